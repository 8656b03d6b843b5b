// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Boats and boxes in water: a boat with a low mast floats upright, one with a heavy mast capsizes, crates float as deep as they are
// dense, an iron ball sinks. Keys: a, z raise and lower the water.
#include <ode/ext.h>

#include <cmath>

#include "stage.h"

static dFluidID water;
static dGeomID crates[4], sound_boat, tall_boat, iron;
static const double kDensities[4] = {200, 400, 600, 800};
static double level = 1.5;

static dReal swell(void*, const dVector3 place, dReal time)
{
    return 0.04 * std::sin(1.5 * place[0] - 2 * time) * std::fmax(0, 1 - time / 6);
}

// A hull of four corners at each end, and a mast of that density.
static dGeomID boat(double x, double y, double mast_density)
{
    const dGeomID deck = demo::box(x, y, level + 0.1, 1.6, 0.7, 0.4, 300);
    dGeomID mast = dCreateCylinder(demo::space, 0.06, 1.4);
    dGeomSetBody(mast, demo::body(deck));
    dGeomSetOffsetPosition(mast, 0, 0, 0.9);
    demo::draw(mast);
    dMass hull, top;
    dMassSetBox(&hull, 300, 1.6, 0.7, 0.4);
    dMassSetCylinder(&top, mast_density, 3, 0.06, 1.4);
    dMassTranslate(&top, 0, 0, 0.9);
    dMassAdd(&hull, &top);
    const double up = hull.c[2];
    dMassTranslate(&hull, 0, 0, -up);
    dBodySetMass(demo::body(deck), &hull);
    dGeomSetOffsetPosition(deck, 0, 0, -up);
    dGeomSetOffsetPosition(mast, 0, 0, 0.9 - up);
    dBodySetPosition(demo::body(deck), x, y, level + 0.1 + up);
    dBodySetAngularVel(demo::body(deck), 0.3, 0, 0);
    return deck;
}

static void build()
{
    water = dFluidCreate(demo::world);
    dFluidSetPlane(water, 0, 0, 1, level);
    dFluidSetSurface(water, swell, nullptr);
    for (int i = 0; i < 4; ++i)
        demo::paint(crates[i] = demo::box(-1.8 + 1.2 * i, 1.4, level + 0.6, 0.6, 0.6, 0.6, kDensities[i]),
                    0.8f, 0.6f, 0.35f, DS_WOOD);
    demo::paint(sound_boat = boat(-1.3, -0.4, 500), 0.9f, 0.35f, 0.3f);
    demo::paint(tall_boat = boat(1.3, -0.4, 9000), 0.3f, 0.5f, 0.9f);
    demo::paint(iron = demo::sphere(0, -1.5, level + 0.3, 0.15, 7800), 0.3f, 0.3f, 0.32f);
}

static void draw_water()
{
    const double pos[3] = {0, 0, level / 2}, sides[3] = {7, 5.5, level};
    const double upright[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    dsSetTexture(DS_NONE);
    dsSetColorAlpha(0.15f, 0.45f, 0.7f, 0.45f);
    dsDrawBoxD(pos, upright, sides);
}

static void calm(double t)
{
    draw_water();
    if (t > 6) dFluidSetSurface(water, nullptr, nullptr);
}

static void key(int key)
{
    level += key == 'a' ? 0.1 : key == 'z' ? -0.1 : 0;
    dFluidSetPlane(water, 0, 0, 1, level);
}

static double upright(dGeomID geom) { return dBodyGetRotation(demo::body(geom))[10]; }

static void judge()
{
    for (int i = 0; i < 4; ++i) {
        dReal volume;
        dFluidGetSubmerged(water, crates[i], &volume, nullptr);
        demo::claim(demo::near(volume, 0.216 * kDensities[i] / 1000, 0.004),
                    "a crate of %g kg/m^3 displaces %g m^3", kDensities[i], volume);
    }
    demo::claim(upright(sound_boat) > 0.95, "the boat with the light mast has a list: %g",
                upright(sound_boat));
    demo::claim(upright(tall_boat) < 0.5, "the boat with the heavy mast has not capsized: %g",
                upright(tall_boat));
    demo::claim(demo::place(iron)[2] < 0.2, "iron floats at %g m", demo::place(iron)[2]);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0.3f, -5.5, 3}, {92, -16, 0}, 20, build, judge, calm, key});
}
