// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pair functions: pure, from two placed shapes to contacts. Each serves one order of the two classes; for
// the other order the dispatcher swaps the arguments and turns the normals round. Which pairs exist:
// collide/pairs/pairs.inc. Planes have no pose and ignore theirs; of a ray's pose only the origin and the
// third column are read.
#pragma once

#include "collide/contact_sink.h"
#include "collide/surfaces/heightfield.h"
#include "collide/surfaces/trimesh.h"
#include "geometry/convex_view.h"
#include "geometry/shapes.h"

namespace epode {

#define PAIR(First, Second, function) \
    void function(const First& a, const Pose& A, const Second& b, const Pose& B, ContactSink& sink);
#include "collide/pairs/mesh_pairs.inc"
#include "collide/pairs/pairs.inc"
#include "collide/pairs/terrain_pairs.inc"
#undef PAIR

// Any two convex solids, by their views. What classes have without a function of their own.
void convex_convex(const ConvexView& a, const ConvexView& b, ContactSink& sink);

// Any convex solid and a plane.
void view_plane(const ConvexView& a, const Plane& b, ContactSink& sink);

// The manifold when the normal is known. `depth` is that of the cores: radii not counted, negative when only
// the inflated solids touch.
void convex_manifold(const ConvexView& a, const ConvexView& b, Vec3 normal, Real depth, ContactSink& sink);

}  // namespace epode
