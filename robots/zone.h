// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The volume of a site (MJCF), which says what of a link's contacts a touch sensor feels: those from which a ray out of the link
// meets it, so also those within.
#pragma once

#include "robots/model.h"

namespace epode::robots {

// Whether the ray from p along d, both in the zone's frame, d of unit length, meets a zone of that size. Kinds: sphere, box, capsule,
// cylinder, ellipsoid.
bool ray_meets_zone(ShapeKind kind, Vec size, Vec p, Vec d);

// Whether a point in the zone's own axes is in it.
bool is_in_zone(ShapeKind kind, Vec size, Vec point);

}  // namespace epode::robots
