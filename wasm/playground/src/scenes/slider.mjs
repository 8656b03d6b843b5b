// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A slider of a scene: what it is called, its range, the distance of two values, and the value at first.
export const slider = (label, low, high, step, value) => ({label, low, high, step, value});
