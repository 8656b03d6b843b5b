// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The same program in C++, where functions without D take doubles too.
#include "every.c"
