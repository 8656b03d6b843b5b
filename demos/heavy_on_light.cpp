// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A block of a tonne on four pillars of a kilogramme each: the exact step carries a ratio of masses of a
// thousand.
#include "stage.h"

static dGeomID pillars[4], block;

static void build()
{
    for (int i = 0; i < 4; ++i) {
        pillars[i] = demo::box(i & 1 ? 0.4 : -0.4, i & 2 ? 0.4 : -0.4, 0.25, 0.1, 0.1, 0.5, 200);
        demo::paint(pillars[i], 0.9f, 0.75f, 0.5f, DS_WOOD);
    }
    demo::paint(block = demo::box(0, 0, 0.75, 1, 1, 0.5, 2000), 0.6f, 0.62f, 0.66f);
}

static void judge()
{
    demo::claim(demo::near(demo::place(block)[2], 0.75, 0.005), "the block stands at %g m",
                demo::place(block)[2]);
    demo::claim(dBodyGetRotation(demo::body(block))[10] > 0.9999, "the block leans");
    for (int i = 0; i < 4; ++i)
        demo::claim(demo::near(demo::place(pillars[i])[2], 0.25, 0.005), "pillar %d stands at %g m", i,
                    demo::place(pillars[i])[2]);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{2, -2, 1.4f}, {135, -20, 0}, 4, build, judge});
}
