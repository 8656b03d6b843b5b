// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cylinder against box and cylinder: the general convex answer; true rims and side lines come from the views,
// and the normals are exact (geometry/overlap/flat_overlap.h).
#include "collide/pairs/pairs.h"

namespace epode {

void cylinder_box(const Cylinder& a, const Pose& A, const Box& b, const Pose& B, ContactSink& sink)
{
    convex_convex(view_of(a, A), view_of(b, B), sink);
}

void cylinder_cylinder(const Cylinder& a, const Pose& A, const Cylinder& b, const Pose& B, ContactSink& sink)
{
    convex_convex(view_of(a, A), view_of(b, B), sink);
}

}  // namespace epode
