// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A tower of ten boxes, each turned a little against the one below, stands and comes to rest.
#include <cmath>

#include "stage.h"

static dGeomID boxes[10];

static void build()
{
    dWorldSetAutoDisableFlag(demo::world, 1);
    for (int i = 0; i < 10; ++i) {
        boxes[i] = demo::box(0, 0, 0.1 + 0.2 * i, 0.4, 0.4, 0.2);
        dMatrix3 turned;
        dRFromAxisAndAngle(turned, 0, 0, 1, 0.15 * i);
        dBodySetRotation(demo::body(boxes[i]), turned);
    }
}

static void judge()
{
    for (int i = 0; i < 10; ++i) {
        const dReal* p = demo::place(boxes[i]);
        demo::claim(demo::near(p[2], 0.1 + 0.2 * i, 0.005), "box %d stands at a height of %g m", i, p[2]);
        demo::claim(std::hypot(p[0], p[1]) < 0.01, "box %d slid by %g m", i, std::hypot(p[0], p[1]));
        demo::claim(!dBodyIsEnabled(demo::body(boxes[i])), "box %d does not rest", i);
    }
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{2.2f, -1.6f, 1.5f}, {144, -8, 0}, 4, build, judge});
}
