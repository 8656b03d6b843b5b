// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ball is shot at a wall of bricks: the wall breaks, bricks fly away from it, none sinks into the ground,
// none is lost.
#include <cmath>

#include "stage.h"

constexpr int kRows = 6, kColumns = 8;
static dGeomID bricks[kRows * kColumns], ball;

static void shoot(int)
{
    dBodySetPosition(demo::body(ball), -6, 0, 0.8);
    dBodySetLinearVel(demo::body(ball), 25, 0, 2.5);
}

static void build()
{
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const double y = 0.5 * (column - 0.5 * (kColumns - 1) + 0.5 * (row % 2) - 0.25);
            bricks[row * kColumns + column] = demo::box(0, y, 0.125 + 0.25 * row, 0.25, 0.5, 0.25, 600);
        }
    }
    demo::paint(ball = demo::sphere(-6, 0, 0.8, 0.3, 3000), 0.25f, 0.25f, 0.3f);
    shoot(0);
}

static void judge()
{
    int moved = 0;
    for (const dGeomID brick : bricks) {
        const dReal* p = demo::place(brick);
        moved += std::fabs(p[0]) > 0.5;
        demo::claim(p[2] > 0.1 && p[2] < 5, "a brick is at a height of %g m", p[2]);
        demo::claim(std::hypot(p[0], p[1]) < 60, "a brick is %g m away", std::hypot(p[0], p[1]));
    }
    demo::claim(moved > 10, "only %d bricks left the wall", moved);
    demo::claim(demo::place(ball)[2] > 0.25, "the ball is at a height of %g m", demo::place(ball)[2]);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{-3.5f, -4.5f, 2.4f}, {50, -15, 0}, 2, build, judge, nullptr, shoot});
}
