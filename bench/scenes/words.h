// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Words that scenes are written in: shapes, bodies with the mass of their shape, what stands still, joints.
#pragma once

#include "bench/scenes/hull.h"
#include "bench/scenes/scene_data.h"

namespace epode::bench {

using scenes::Lcg;

constexpr double kDensity = 1000;  // kg/m3

ShapeData sphere(double radius);
ShapeData box(Vec sides);
ShapeData capsule(double radius, double length);
ShapeData cylinder(double radius, double length);

// The number of the shape, for any number of bodies.
int add_shape(SceneData& scene, ShapeData shape);

// The number of the body. Its mass is that of its shape.
int add_body(SceneData& scene, int shape, Vec pos, Turn turn = {}, double density = kDensity);
int add_static(SceneData& scene, int shape, Vec pos, Turn turn = {});
// As it was, with another mass: inertia in proportion.
void set_mass(BodyData& body, double mass);

// A floor with its top at z = 0, 2 m thick, as wide as `half` either way.
void add_floor(SceneData& scene, double half);
// A floor and four walls, 2 m thick; inner sides `side`.
void add_pit(SceneData& scene, double side, double height);
// The terrain becomes the scene's own, and a static mesh.
void add_terrain(SceneData& scene, Terrain terrain);

int add_ball(SceneData& scene, int body1, int body2, Vec anchor);
int add_hinge(SceneData& scene, int body1, int body2, Vec anchor, Vec axis, double low = 0, double high = 0);

// Sphere, box, capsule, cylinder, ..., half a metre to a metre in size: eight of each kind.
std::vector<int> add_mixed_shapes(SceneData& scene, bool hulls, Lcg& random);

}  // namespace epode::bench
