// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A library that exports.sh and needed.sh must refuse: a foreign symbol, an undeclared one, another
// name, and almost everything missing.
#define VISIBLE __attribute__((visibility("default")))

VISIBLE int stray_symbol(void);
VISIBLE int dUndeclared(void);

int stray_symbol(void) { return 1; }
int dUndeclared(void) { return 2; }
