// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What wasm/interface.py writes: the numbers of C's enumerations and the layouts of its structures.
export const real: 'Float32' | 'Float64';
export const constants: {readonly [name: string]: number};
export const structures: {readonly [name: string]: {size: number; fields: {[name: string]: [offset: number, kind: string, count: number]}}};
