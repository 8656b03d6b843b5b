// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays of the narrow phase: how far it is from a point of a solid to the other geom along a direction.
#pragma once

#include "collide/geom.h"

namespace epode {

struct RayHit {
    Real distance = kInf;  // nothing
    Vec3 normal{};
};

// `other` being at that pose; a mesh's triangles are those that its callback wants of the solid. `direction` has length 1.
RayHit cast_long_ray(Vec3 from, Vec3 direction, Geom& solid, Geom& other, const Pose& pose);

}  // namespace epode
