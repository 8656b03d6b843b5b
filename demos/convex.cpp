// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gems, convex hulls of points, fall on a pile: they collide as what they look like, and their mass is that
// of their form.
#include <ode/ext.h>

#include <cmath>

#include "stage.h"

constexpr int kGems = 12, kPoints = 9;
// An octahedron whose upper point is cut off: four sides below, four above, one on top.
static const dReal points[] = {0.3f, 0,     0,     0,      0.3f, 0,     -0.3f, 0,      0,
                               0,    -0.3f, 0,     0,      0,    -0.4f, 0.15f, 0,      0.15f,
                               0,    0.15f, 0.15f, -0.15f, 0,    0.15f, 0,     -0.15f, 0.15f};
static dGeomID gems[kGems];

static void build()
{
    for (int i = 0; i < kGems; ++i) {
        gems[i] = demo::draw(dCreateConvexHull(demo::space, points, kPoints, 0));
        demo::paint(gems[i], i % 3 == 0 ? 0.9f : 0.35f, i % 3 == 1 ? 0.8f : 0.4f, i % 3 == 2 ? 0.9f : 0.5f);
        const dBodyID body = dBodyCreate(demo::world);
        dMass mass;
        dMassSetConvex(&mass, 1000, gems[i]);
        // A body's origin is its centre of mass.
        dGeomSetBody(gems[i], body);
        dGeomSetOffsetPosition(gems[i], -mass.c[0], -mass.c[1], -mass.c[2]);
        dMassTranslate(&mass, -mass.c[0], -mass.c[1], -mass.c[2]);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, 0.12 * (i % 3 - 1), 0.12 * (i % 2), 0.6 + 0.7 * i);
    }
}

static void judge()
{
    for (int i = 0; i < kGems; ++i) {
        const dReal *p = demo::place(gems[i]), *R = dGeomGetRotation(gems[i]);
        double lowest = 1e9;
        for (int k = 0; k < kPoints; ++k)
            lowest = std::fmin(lowest, p[2] + dCalcVectorDot3(R + 8, points + 3 * k));
        demo::claim(lowest > -0.02, "gem %d is %g m in the ground", i, -lowest);
        demo::claim(p[2] < 1.5, "gem %d hangs at %g m", i, p[2]);
        const dReal* v = dBodyGetLinearVel(demo::body(gems[i]));
        demo::claim(std::sqrt(dCalcVectorDot3(v, v)) < 0.5, "gem %d still moves", i);
    }
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{2.4f, -2.4f, 1.7f}, {135, -20, 0}, 6, build, judge});
}
