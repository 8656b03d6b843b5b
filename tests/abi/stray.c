// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A library that exports.sh, needed.sh, allocations.sh and hardening.sh must refuse: a foreign symbol, an
// undeclared one, another name, almost everything missing, memory past the client's handlers, variables read
// from anybody's environment, room in the static TLS block.
#include <stdlib.h>

#define VISIBLE __attribute__((visibility("default")))

VISIBLE int stray_symbol(void);
VISIBLE int dUndeclared(void);
VISIBLE void* stray_memory(void);
VISIBLE int stray_environment(void);

int stray_symbol(void) { return 1; }
int dUndeclared(void) { return 2; }
void* stray_memory(void) { return malloc(8); }
int stray_environment(void)
{
    static _Thread_local int count __attribute__((tls_model("initial-exec")));
    return getenv("STRAY") ? ++count : 0;
}
