/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * CHECK for the guide programs: prints what failed and ends the program with status 1. assert() would do, but
 * a build with NDEBUG must not turn the tests into programs that check nothing.
 */
#ifndef GUIDE_CHECK_H
#define GUIDE_CHECK_H

#include <stdio.h>
#include <stdlib.h>

#define CHECK(condition)                                                              \
    do {                                                                              \
        if (!(condition)) {                                                           \
            fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition); \
            exit(1);                                                                  \
        }                                                                             \
    } while (0)

#define CHECK_CLOSE(value, wanted, tolerance)                                                          \
    do {                                                                                               \
        const double got_ = (double)(value), want_ = (double)(wanted);                                 \
        if (!(got_ - want_ <= (tolerance) && want_ - got_ <= (tolerance))) {                           \
            fprintf(stderr, "%s:%d: %s is %.9g, not %.9g\n", __FILE__, __LINE__, #value, got_, want_); \
            exit(1);                                                                                   \
        }                                                                                              \
    } while (0)

#endif
