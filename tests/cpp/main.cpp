// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every member of every C++ wrapper against the C call it stands for (see twins.h). Exit status 1 when any
// differs. What was read is printed, one check a line.
#include "twins.h"

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
