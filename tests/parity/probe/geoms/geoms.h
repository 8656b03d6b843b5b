// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Random geoms of every class of the pair table, in random poses, for the pair_* and geom_* cases.
//
// A geom of each kind knows the radius of a ball about its position that holds it; two geoms are put at a
// distance of 0.2 to 1.05 times the sum of their radii, which makes roughly half of the poses hits and
// many of the rest near misses.
#pragma once

#include "case_list.h"

#include <array>

namespace parity {

enum class Kind { kSphere, kBox, kCapsule, kCylinder, kPlane, kRay, kTransform, kConvex };

constexpr std::array<Kind, 8> kKinds = {Kind::kSphere, Kind::kBox, Kind::kCapsule,   Kind::kCylinder,
                                        Kind::kPlane,  Kind::kRay, Kind::kTransform, Kind::kConvex};

// The arrays that a convex geom was made of; the original reads them as long as the geom lives. A box, or a
// frustum of one: the top smaller than the bottom.
struct ConvexArrays {
    std::array<dReal, 24> points;
    std::array<dReal, 24> planes;
};

const char* kind_name(Kind kind);

struct Placed {
    dGeomID geom;
    double radius;
};

// Of a geom made by make_geom.
const ConvexArrays& convex_arrays(dGeomID geom);
const unsigned* convex_polygons();

Placed make_geom(Kind kind, dSpaceID space, Random& random);

// Puts the geom at the point in a random orientation; a plane gets a random normal and passes near the point.
void place_geom(const Placed& placed, Kind kind, const Vec3& point, Random& random);

// Is one of the two a ray that misses the other's bounding box? The original's spaces report such pairs, ours
// do not (differences.tsv, C38).
bool a_ray_passes_by(dGeomID a, dGeomID b);

}  // namespace parity
