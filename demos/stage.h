// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all demos share, so that each can be about its one thing: a world with a floor and gravity (0, 0,
// -9.81), bodies with shapes in one call, contacts, drawing, and a verdict. A demo claims what its physics
// must do; the first claim that does not hold is printed, and the program ends with exit code 1. In a window it
// goes on after its verdict.
#pragma once

#include <drawstuff/drawstuff.h>
#include <ode/ode.h>

namespace demo {

constexpr double kStep = 1.0 / 120;  // unless a plan has other steps

struct Plan {
    float eye[3], look[3];  // dsSetViewpoint
    double seconds;         // until the verdict
    void (*build)();
    void (*judge)();
    void (*every_step)(double t) = nullptr;  // before each step of the world
    void (*key)(int key) = nullptr;
    void (*surface)(dGeomID a, dGeomID b, dContact* contact) = nullptr;  // of a contact that is not made yet
    int steps_a_frame = 2;                                               // of 1/60 s
    bool world_contacts = false;  // not by a callback, but by the materials of its geoms
};

extern dWorldID world;
extern dSpaceID space;
extern dReal friction, bounce;  // of all contacts; at first 1 and 0

// A body with one geom and the mass of its volume, standing at (x, y, z). The demo draws it from then on.
dGeomID box(double x, double y, double z, double sx, double sy, double sz, double density = 1000);
dGeomID sphere(double x, double y, double z, double radius, double density = 1000);
dGeomID capsule(double x, double y, double z, double radius, double length, double density = 1000);
dGeomID cylinder(double x, double y, double z, double radius, double length, double density = 1000);

// A geom of the demo's own making, or one without a body, is drawn too.
dGeomID draw(dGeomID geom);
// Colour and texture of a geom; those that nobody paints get colours in turn.
dGeomID paint(dGeomID geom, float r, float g, float b, int texture = DS_NONE);

dBodyID body(dGeomID geom);
const dReal* place(dGeomID geom);

// Says on stderr what does not hold, as printf would.
void claim(bool holds, const char* format, ...);
bool near(double a, double b, double tolerance);

int run(int argc, char** argv, const Plan& plan);

}  // namespace demo
