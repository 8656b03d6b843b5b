// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A judgement that cannot be compiled away: says what is not so and ends the program with status 1.
#ifndef TESTS_CPP_GUIDE_CHECK_H
#define TESTS_CPP_GUIDE_CHECK_H

#include <cmath>
#include <cstdio>
#include <cstdlib>

/** `what` must lie within `tolerance` of `wanted`. */
inline void expect_close(const char* what, double got, double wanted, double tolerance)
{
    const bool close = std::fabs(got - wanted) <= tolerance;
    std::printf("%-44s %12.6g  wanted %12.6g +- %.2g%s\n", what, got, wanted, tolerance, close ? "" : "  NO");
    if (!close) std::exit(1);
}

/** `what` must be so. */
inline void expect(const char* what, bool so)
{
    std::printf("%-44s %s\n", what, so ? "yes" : "NO");
    if (!so) std::exit(1);
}

#endif
