// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Shapes: cones, ellipsoids and tapered capsules dropped into a pit, three of each kind set up by hand before
// it: a cone that stands, one that lies, an egg on its end that falls over. A library without these shapes
// pours balls.
#include "scenes/build.h"
#include "scenes/extensions.h"

namespace epode::scenes {

namespace {

constexpr int kAcross = 5, kCount = 100;

// Of the shape's mass the given volume weighs as water.
void add_shape(Scene& scene, dGeomID geom, dMass mass, double radius, Vec pos, Turn q = {})
{
    if (geom)
        add_body(scene, geom, mass, pos, q);
    else
        add_sphere(scene, radius, 1000, pos);
}

void add_cone(Scene& scene, double radius, double length, Vec pos, Turn q = {})
{
    dMass mass;
    add_shape(scene, create_cone(scene.space(), radius, length, mass), mass, radius, pos, q);
}
void add_ellipsoid(Scene& scene, Vec radii, Vec pos, Turn q = {})
{
    dMass mass;
    add_shape(scene, create_ellipsoid(scene.space(), radii.x, radii.y, radii.z, mass), mass, radii.x, pos, q);
}
void add_tapered_capsule(Scene& scene, double r1, double r2, double length, Vec pos, Turn q = {})
{
    dMass mass;
    add_shape(scene, create_tapered_capsule(scene.space(), r1, r2, length, mass), mass, r1, pos, q);
}

void add_one(Scene& scene, Lcg& random, int kind, Vec pos)
{
    const double size = random.uniform(0.2, 0.3);
    const Turn q = random.any_turn();
    if (kind == 0) add_cone(scene, size, random.uniform(1.5, 2.5) * size, pos, q);
    if (kind == 1) add_ellipsoid(scene, {size, random.uniform(0.5, 0.9) * size, 1.3 * size}, pos, q);
    if (kind == 2) add_tapered_capsule(scene, 0.8 * size, random.uniform(0.3, 0.6) * size, size, pos, q);
}

void build(Scene& scene)
{
    Lcg random(scene.seed());
    const double half = 1.9, pitch = 0.72;
    add_ground(scene);
    add_pit(scene, half, half, 0.8);
    add_cone(scene, 0.4, 1, {-1.2, -3, 0.25});
    add_cone(scene, 0.4, 1, {-0.1, -3, 0.3}, turn(kX, kPi / 2));
    add_ellipsoid(scene, {0.3, 0.3, 0.45}, {1.0, -3, 0.46}, turn(kX, 0.05));
    add_tapered_capsule(scene, 0.35, 0.15, 0.6, {1.9, -3, 0.36}, turn(kX, kPi / 2));
    for (int i = 0; i < kCount; ++i) {
        const int column = i % kAcross, row = i / kAcross % kAcross, layer = i / (kAcross * kAcross);
        const Vec grid{(column - 0.5 * (kAcross - 1)) * pitch, (row - 0.5 * (kAcross - 1)) * pitch,
                       0.6 + layer * pitch};
        add_one(scene, random, i % 3,
                grid + Vec{random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08), 0});
    }
    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    dWorldSetContactMaxCorrectingVel(scene.world(), 5);
    set_view(scene, {-3.6, -8.2, 4.6}, {0.1, -0.9, 0.4});
}

}  // namespace

extern const Recipe kShapes = {
    .name = "shapes",
    .description = "100 cones, ellipsoids and tapered capsules poured into a pit",
    .dt = 0.005,
    .seconds = 4,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
