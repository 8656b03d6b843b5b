// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gems, convex hulls of points, fall on a heap: they collide as what they look like. Their mass is that of a
// box about as large.
#include <cmath>

#include "stage.h"

constexpr int kGems = 12;
// An octahedron whose upper point is cut off: four sides below, four above, one on top.
static const dReal points[] = {0.3f, 0,     0,     0,      0.3f, 0,     -0.3f, 0,      0,
                               0,    -0.3f, 0,     0,      0,    -0.4f, 0.15f, 0,      0.15f,
                               0,    0.15f, 0.15f, -0.15f, 0,    0.15f, 0,     -0.15f, 0.15f};
static const unsigned polygons[] = {3, 0, 4, 1, 3, 1, 4, 2, 3, 2, 4, 3, 3, 3, 4, 0, 4, 0, 1, 6, 5,
                                    4, 1, 2, 7, 6, 4, 2, 3, 8, 7, 4, 3, 0, 5, 8, 4, 5, 6, 7, 8};
constexpr int kFaces = 9, kPoints = 9;
static dReal planes[4 * kFaces];
static dGeomID gems[kGems];

static void make_planes()
{
    const unsigned* polygon = polygons;
    for (int face = 0; face < kFaces; ++face) {
        const dReal *a = points + 3 * polygon[1], *b = points + 3 * polygon[2], *c = points + 3 * polygon[3];
        const dReal u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                    v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        dReal* plane = planes + 4 * face;
        dCalcVectorCross3(plane, u, v);
        const dReal length = std::sqrt(dCalcVectorDot3(plane, plane));
        for (int i = 0; i < 3; ++i) plane[i] /= length;
        plane[3] = dCalcVectorDot3(plane, a);
        polygon += 1 + *polygon;
    }
}

static void build()
{
    make_planes();
    for (int i = 0; i < kGems; ++i) {
        const dBodyID body = dBodyCreate(demo::world);
        gems[i] = demo::draw(dCreateConvex(demo::space, planes, kFaces, points, kPoints, polygons));
        dMass mass;
        dMassSetBox(&mass, 1000, 0.4, 0.4, 0.4);
        dBodySetMass(body, &mass);
        dGeomSetBody(gems[i], body);
        dBodySetPosition(body, 0.12 * (i % 3 - 1), 0.12 * (i % 2), 0.6 + 0.7 * i);
    }
}

static void draw(double)
{
    for (int i = 0; i < kGems; ++i) {
        dsSetColor(i % 3 == 0 ? 0.9f : 0.35f, i % 3 == 1 ? 0.8f : 0.4f, i % 3 == 2 ? 0.9f : 0.5f);
        dsDrawConvex(demo::place(gems[i]), dGeomGetRotation(gems[i]), planes, kFaces, points, kPoints,
                     polygons);
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
    return demo::run(argc, argv, {{2.4f, -2.4f, 1.7f}, {135, -20, 0}, 6, build, judge, draw});
}
