// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Judges checks of the wrappers and prints what was read (see twins.h).
#include "twins.h"

int g_checks = 0, g_failures = 0;

void judge(const char* name, bool passed, const Numbers& values)
{
    ++g_checks;
    if (!passed) {
        ++g_failures;
        std::fprintf(stderr, "FAILED %s\n", name);
    }
    std::printf("%s", name);
    for (std::size_t i = 0; i < values.size(); ++i) std::printf(" %.17g", values[i]);
    std::printf("\n");
}

namespace {

bool equal(const Numbers& a, const Numbers& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(&a[0], &b[0], a.size() * sizeof a[0]) == 0);
}

}  // namespace

void judge_set(const char* name, const Numbers& before, const Numbers& wrapped, const Numbers& plain)
{
    judge(name, equal(wrapped, plain) && !equal(wrapped, before), wrapped);
}

void judge_get(const char* name, double wrapped, double plain)
{
    judge(name, wrapped == plain, Numbers(1, wrapped));
}

void judge_get(const char* name, const Numbers& wrapped, const Numbers& plain)
{
    judge(name, !wrapped.empty() && equal(wrapped, plain), wrapped);
}
