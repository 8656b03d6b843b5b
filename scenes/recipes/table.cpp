// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Table: what rests on more supports than it needs. A four-legged table (legs are rigid: four feet with four
// contacts each, where three points would do) carries a box, and next to it a box stands with every contact
// made twice. The forces are not unique, the motion is: nothing may move. The matrix of the contact rows is
// singular; a stepper must not mind.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

dBodyID add_table(Scene& scene, Vec at)
{
    const Vec top{1.6, 0.9, 0.06}, leg{0.08, 0.08, 0.7};
    const double density = 700, drop = top.z / 2 + leg.z / 2;
    dMass mass, part;
    dMassSetBox(&mass, dReal(density), dReal(top.x), dReal(top.y), dReal(top.z));
    Vec feet[4];
    for (int i = 0; i < 4; ++i) {
        const Vec foot{(i % 2 ? 1 : -1) * (top.x / 2 - leg.x), (i / 2 ? 1 : -1) * (top.y / 2 - leg.y), -drop};
        dMassSetBox(&part, dReal(density), dReal(leg.x), dReal(leg.y), dReal(leg.z));
        dMassTranslate(&part, dReal(foot.x), dReal(foot.y), dReal(foot.z));
        dMassAdd(&mass, &part);
        feet[i] = foot;
    }
    // Everything is shifted so that the common centre of mass is the body's origin.
    const Vec shift{-mass.c[0], -mass.c[1], -mass.c[2]};
    dMassTranslate(&mass, dReal(shift.x), dReal(shift.y), dReal(shift.z));
    mass.c[0] = mass.c[1] = mass.c[2] = 0;

    dBodyID table = add_box(scene, top, density, at + Vec{0, 0, leg.z + top.z / 2} - shift);
    dGeomSetOffsetPosition(dBodyGetFirstGeom(table), dReal(shift.x), dReal(shift.y), dReal(shift.z));
    dBodySetMass(table, &mass);
    for (const Vec& foot : feet) attach_box(scene, table, leg, foot + shift);
    return table;
}

void build(Scene& scene)
{
    add_ground(scene);
    dBodyID table = add_table(scene, {-0.5, 0, 0});
    add_box(scene, {0.4, 0.3, 0.25}, 500, {-0.7, 0.05, 0.76 + 0.125}, turn(kZ, 0.4));
    add_box(scene, {0.5, 0.5, 0.5}, 500, {1.2, 0, 0.25}, turn(kZ, 0.2));
    scene.contact_copies = 2;
    scene.tracked = {table};
    set_view(scene, {-1.4, -3.8, 1.7}, {0.15, 0, 0.45});
}

}  // namespace

extern const Recipe kTable = {
    .name = "table",
    .description = "a laden four-legged table and a box, at rest on twice as many contacts as there are",
    .dt = 0.01,
    .seconds = 3,
    .stepper = Stepper::kExact,
    .build = build,
};

}  // namespace epode::scenes
