// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The shapes as pure numbers, each in its own frame: no ids, no world, no pose. Axes of capsule and cylinder
// lie along local z, as in ODE; ODE's full lengths become half lengths here.
#pragma once

#include "math/pose.h"

namespace epode {

struct Sphere {
    Real radius = 1;
};
struct Box {
    Vec3 half{Real(0.5), Real(0.5), Real(0.5)};
};
struct Capsule {
    Real radius = 1;
    Real half_length = Real(0.5);  // of the segment between the centres of the caps
};
struct Cylinder {
    Real radius = 1;
    Real half_length = Real(0.5);
};
// The half-space normal . x <= d, in the world: planes have no pose.
struct Plane {
    Vec3 normal{0, 0, 1};
    Real d = 0;
};
// From the pose's origin along its z axis.
struct Ray {
    Real length = 0;
    bool first_contact = false;  // these three matter to meshes only
    bool backface_cull = false;
    bool closest_hit = false;
};

class Polyhedron;
// Owned by the geom, which is as old as its pairs (geometry/hulls/polyhedron.h).
struct Convex {
    const Polyhedron* solid = nullptr;
};

struct Aabb {
    Vec3 lo, hi;
};
// Closed: boxes that touch overlap.
constexpr bool overlap(const Aabb& a, const Aabb& b)
{
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y && a.lo.z <= b.hi.z &&
           b.lo.z <= a.hi.z;
}

}  // namespace epode
