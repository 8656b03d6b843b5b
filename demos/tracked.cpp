// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A tracked vehicle: its tracks do not move, the surface of their contacts does, along the track. It climbs
// over a beam, stops, and turns on the spot. Keys: a and z both tracks faster and slower, comma and full stop
// turn.
#include <cmath>

#include "stage.h"

static dGeomID hull, beam;
constexpr double kTurn = 5;
static double speed[2] = {1, 1}, highest = 0, stop[2];
static int side_of(dGeomID geom)
{
    return dGeomGetCategoryBits(geom) == 2 ? 0 : dGeomGetCategoryBits(geom) == 4 ? 1 : -1;
}

static void add(dGeomID part, unsigned long side, double x, double y, double z)
{
    dMatrix3 across;
    dGeomSetBody(demo::paint(demo::draw(part), 0.3f, 0.3f, 0.32f, DS_CHECKERED), demo::body(hull));
    dGeomSetOffsetPosition(part, x, y, z);
    dRFromAxisAndAngle(across, 1, 0, 0, M_PI / 2);
    if (dGeomGetClass(part) == dCylinderClass) dGeomSetOffsetRotation(part, across);
    dGeomSetCategoryBits(part, side);
}

static void build()
{
    demo::paint(hull = demo::box(0, 0, 0.5, 1.4, 0.7, 0.3, 700), 0.45f, 0.55f, 0.3f);
    for (int side = 0; side < 2; ++side) {
        const double y = side == 0 ? 0.5 : -0.5;
        add(dCreateBox(demo::space, 1.4, 0.25, 0.5), 2u << side, 0, y, -0.2);
        for (int end = -1; end <= 1; end += 2)
            add(dCreateCylinder(demo::space, 0.25, 0.24), 2u << side, 0.7 * end, y, -0.2);
    }
    dGeomSetPosition(demo::draw(beam = dCreateBox(demo::space, 0.3, 3, 0.2)), 2.5, 0, 0.1);
}

// Of a contact with something that has no body, motion1 is the speed of the body that there is, along fdir1.
static void roll(dGeomID a, dGeomID b, dContact* contact)
{
    const int side = side_of(a) >= 0 ? side_of(a) : side_of(b);
    if (side < 0) return;
    const dReal *R = dBodyGetRotation(demo::body(hull)), *n = contact->geom.normal;
    const double out = side_of(a) >= 0 ? 1 : -1, left[3] = {out * R[1], out * R[5], out * R[9]};
    dCalcVectorCross3(contact->fdir1, left, n);
    if (!dSafeNormalize3(contact->fdir1)) return;
    contact->surface.mode |= dContactFDir1 | dContactMotion1 | dContactMu2;
    contact->surface.mu2 = 0.4;  // tracks slip sideways
    contact->surface.motion1 = speed[side];
}

static void drive(double t)
{
    highest = std::fmax(highest, demo::place(hull)[2]);
    if (t < kTurn) {
        for (int k = 0; k < 2; ++k) stop[k] = demo::place(hull)[k];
    } else if (t < kTurn + demo::kStep) {
        speed[0] = -0.6, speed[1] = 0.6;
    }
}

static void key(int key)
{
    const double left = key == 'a' || key == '.' ? 0.2 : key == 'z' || key == ',' ? -0.2 : 0;
    speed[0] += left;
    speed[1] += key == '.' || key == ',' ? -left : left;
}

static void judge()
{
    const dReal *p = demo::place(hull), *R = dBodyGetRotation(demo::body(hull));
    demo::claim(highest > 0.7, "the beam was not climbed: %g m", highest);
    demo::claim(demo::near(p[2], 0.45, 0.01), "it ends at a height of %g m", p[2]);
    demo::claim(stop[0] > 4 && std::fabs(stop[1]) < 0.1, "it came to %g %g", stop[0], stop[1]);
    demo::claim(std::atan2(R[4], R[0]) > 2, "it turned by %g rad", std::atan2(R[4], R[0]));
    demo::claim(std::hypot(p[0] - stop[0], p[1] - stop[1]) < 0.25, "it left the spot by %g m",
                std::hypot(p[0] - stop[0], p[1] - stop[1]));
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{2, -5, 2.2f}, {90, -18, 0}, 8, build, judge, drive, key, roll});
}
