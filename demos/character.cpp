// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A character of ode/character.h climbs stairs, walks down a slope, pushes a crate and rides a lift. Keys: a, z, comma and full stop
// walk, space jumps.
#include <ode/ext.h>

#include <cmath>

#include "stage.h"

static dGeomID hero, crate, lift;
static double wanted[2] = {2, 0}, jump = 0, on_stairs = 0, lifted = 0;
static bool walked = false;

static dGeomID slab(double x, double z, double sx, double sz)
{
    const dGeomID geom = demo::draw(dCreateBox(demo::space, sx, 3, sz));
    dGeomSetPosition(geom, x, 0, z);
    return demo::paint(geom, 0.8f, 0.7f, 0.55f, DS_WOOD);
}

static void build()
{
    for (int i = 0; i < 5; ++i) slab(2.2 + 0.4 * i, 0.1 * (i + 1), 0.4, 0.2 * (i + 1));
    slab(4.8, 0.5, 1.6, 1);
    dMatrix3 slope;
    dRFromAxisAndAngle(slope, 0, 1, 0, std::atan2(1, 2.4));
    const dGeomID ramp = slab(6.78, 0.45, 2.6, 0.1);
    dGeomSetRotation(ramp, slope);
    demo::paint(crate = demo::box(9.5, 0, 0.3, 0.6, 0.6, 0.6, 150), 0.5f, 0.7f, 0.4f, DS_WOOD);
    demo::paint(lift = demo::box(13, 0, -0.05, 3, 3, 0.2, 100), 0.3f, 0.5f, 0.9f);
    dBodySetKinematic(demo::body(lift));
    dGeomSetCategoryBits(lift, 2);
    dGeomSetCollideBits(lift, ~2ul);
    hero = demo::paint(demo::draw(dCharacterCreate(demo::space, nullptr)), 0.9f, 0.35f, 0.3f);
}

static void step(double)
{
    dVector3 feet;
    dCharacterGetPosition(hero, feet);
    const bool rides = feet[0] > 12.9;
    if (!walked && rides) wanted[0] = 0;
    dBodySetLinearVel(demo::body(lift), 0, 0, rides && lifted < 1 ? 0.5 : 0);
    const dVector3 velocity = {wanted[0], wanted[1], 0};
    dCharacterWalk(hero, velocity, jump, demo::kStep);
    jump = 0;
    if (feet[0] > 4 && feet[0] < 5.5) on_stairs = std::fmax(on_stairs, feet[2]);
    lifted = demo::place(lift)[2] + 0.05;
}

static void key(int key)
{
    walked = true;
    wanted[0] += key == 'a' ? 1 : key == 'z' ? -1 : 0;
    wanted[1] += key == ',' ? 1 : key == '.' ? -1 : 0;
    if (key == ' ') jump = 4;
}

static void judge()
{
    dCharacterReport report;
    report.struct_size = sizeof report;
    dCharacterGetReport(hero, &report);
    dVector3 feet;
    dCharacterGetPosition(hero, feet);
    demo::claim(demo::near(on_stairs, 1, 0.02), "the stairs were climbed to %g m", on_stairs);
    demo::claim(demo::place(crate)[0] > 10 || std::fabs(demo::place(crate)[1]) > 0.3, "the crate is at %g m",
                demo::place(crate)[0]);
    demo::claim(report.ground == lift, "it does not stand on the lift, but at %g %g %g", feet[0], feet[1],
                feet[2]);
    demo::claim(demo::near(feet[2], 1.05, 0.05), "the lift has it at %g m", feet[2]);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{7, -11, 5}, {90, -20, 0}, 12, build, judge, step, key, nullptr, 2, true});
}
