// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A threading implementation of a program's own, written after the contract in ode/threading.h: calls in a
// list, a few threads that take those without dependencies, one lock for everything. It keeps count of what
// it was asked, so that a test can tell whether a library really used it.
#ifndef OWN_THREADS_H
#define OWN_THREADS_H

#include <ode/ode.h>

struct own_counts {
    unsigned posted, finished, waited, prepared;
    unsigned waits_made, waits_freed, groups_made, groups_freed, locked, unlocked;
    unsigned widest;     /* most calls that ran at the same time */
    unsigned on_waiters; /* calls that a thread other than its own ran: must stay 0 */
};

/* The handle and the table to give to a world. Threads: 1 ... 16. */
dThreadingImplementationID own_start(unsigned threads);
const dThreadingFunctionsInfo* own_functions(void);
struct own_counts own_count(dThreadingImplementationID impl);
/* Ends the threads. Returns how many calls were left, which should be none. */
unsigned own_stop(dThreadingImplementationID impl);

#endif
