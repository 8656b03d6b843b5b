// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms that are convex solids (spheres, boxes, capsules, cylinders, polyhedra) as functions of distance and
// of parting directions see them.
#pragma once

#include "collide/geom.h"
#include "geometry/convex_view.h"

namespace epode {

// Whether the geom is one.
bool is_solid(const Geom& geom);
// Of a solid, at that pose; it must stay while the view is used.
ConvexView solid_view(const Geom& solid, const Pose& pose);

}  // namespace epode
