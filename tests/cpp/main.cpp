// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every member of every C++ wrapper against the C call it stands for (see twins.h). Exit status 1 when any
// differs. What was read is printed, one check a line.
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

int main()
{
    dInitODE();
    test_world();
    test_body();
    test_joint_group_and_base();
    test_joint_types();
    test_geoms();
    test_spaces();
    test_mass();
    dCloseODE();
    std::fprintf(stderr, "%d checks of the wrappers, %d failed\n", g_checks, g_failures);
    return g_failures != 0;
}
