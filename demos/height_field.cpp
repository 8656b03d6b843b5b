// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Balls and boxes on hills, whose heights a function tells: balls roll into the valleys, unless something
// lies there.
#include <cmath>

#include "stage.h"

constexpr int kCells = 40, kBodies = 16;
constexpr double kWide = 8;
static dGeomID field, solids[kBodies];

static dReal hills(void*, int i, int k)
{
    return static_cast<dReal>(0.6 + 0.5 * std::cos(2 * M_PI * i / 20) * std::cos(2 * M_PI * k / 20));
}

// A field's heights lie along its y; turned about x they lie along z.
static void build()
{
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildCallback(data, nullptr, hills, kWide, kWide, kCells + 1, kCells + 1, 1, 0, 1, 0);
    dGeomHeightfieldDataSetBounds(data, 0, 1.2);
    field = dCreateHeightfield(demo::space, data, 1);
    dMatrix3 upright;
    dRFromAxisAndAngle(upright, 1, 0, 0, M_PI / 2);
    dGeomSetRotation(field, upright);
    for (int i = 0; i < kBodies; ++i) {
        const double x = 1.3 * (i % 4 - 1.5), y = 1.3 * (i / 4 - 1.5);
        solids[i] = i % 2 ? demo::sphere(x, y, 2, 0.2) : demo::box(x, y, 2, 0.4, 0.4, 0.25);
        dBodySetAngularDamping(demo::body(solids[i]), 0.02);
    }
}

// Local (x, h, z) stands at the world's (x, -z, h).
static void corner(int i, int k, dReal* p)
{
    p[0] = static_cast<dReal>(kWide * i / kCells - kWide / 2);
    p[1] = static_cast<dReal>(kWide / 2 - kWide * k / kCells);
    p[2] = hills(nullptr, i, k);
}

static void draw(double)
{
    const dReal none[3] = {0, 0, 0}, flat[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    dsSetColor(0.8f, 0.75f, 0.6f);
    for (int i = 0; i < kCells; ++i) {
        for (int k = 0; k < kCells; ++k) {
            dVector3 a, b, c, d;
            corner(i, k, a);
            corner(i + 1, k, b);
            corner(i + 1, k + 1, c);
            corner(i, k + 1, d);
            dsDrawTriangle(none, flat, a, c, b, 1);
            dsDrawTriangle(none, flat, a, d, c, 1);
        }
    }
}

static double ground(double x, double y)
{
    return 0.6 + 0.5 * std::cos(2 * M_PI * (x + 4) / 4) * std::cos(2 * M_PI * (4 - y) / 4);
}

static void judge()
{
    double balls = 0;
    for (int i = 0; i < kBodies; ++i) {
        const dReal* p = demo::place(solids[i]);
        const double over = p[2] - ground(p[0], p[1]);
        demo::claim(over > 0.1 && over < 0.5, "thing %d is %g m over the ground", i, over);
        if (i % 2) balls += p[2] / (kBodies / 2);
    }
    // Of a valley's floor a ball's middle is 0.3 m high, of a hill's top 1.3 m.
    demo::claim(balls < 0.6, "the balls found no valleys: they are %g m high in the mean", balls);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0, -6.5f, 4.2f}, {90, -33, 0}, 14, build, judge, draw});
}
