// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a class of convex solids provides for its geoms, and all that the rest of the library needs of them:
// pairs with every other class, queries, separation tests, continuous collision and drawing follow from the
// view (geometry/convex_view.h), that is from a support function. A view is a core and a radius around it.
// The other functions have a default by the view; a class replaces those that it can compute faster.
#pragma once

#include "collide/geom.h"
#include "geometry/convex_view.h"

namespace epode {

// The core about the geom's place: its farthest point, and the radius around it.
struct CoreSize {
    Real farthest, radius;
};

class RevolvedSolid;  // geometry/immersion/revolved_solid.h

// Answered by the view alone.
Real core_reach_by_view(const Geom& geom, Vec3 direction);
CoreSize core_size_by_view(const Geom& geom);
Aabb box_by_view(Geom& geom);
Real half_thickness_by_view(const Geom& geom);

struct SolidType {
    // At that pose; the geom must outlive the view.
    ConvexView (*view)(const Geom& geom, const Pose& pose) = nullptr;
    // How far the core reaches from the geom's place along a direction of its own frame, of about length 1.
    Real (*core_reach)(const Geom& geom, Vec3 direction) = core_reach_by_view;
    CoreSize (*core_size)(const Geom& geom) = core_size_by_view;
    // It is curved: what touches is no point of the body, as corners are, but wherever its surface comes
    // nearest; and triangles of meshes touch it with their fronts only.
    bool round = true;
    // What fluids need of it (src/fluid), in the geom's frame; null: it does not float, but for boxes and polyhedra.
    RevolvedSolid (*round_solid)(const Geom& geom) = nullptr;
};

inline bool is_solid(const Geom& geom) { return geom.type->solid != nullptr; }
// Of a solid.
inline ConvexView solid_view(const Geom& solid, const Pose& pose)
{
    return solid.type->solid->view(solid, pose);
}

template <typename Shape>
ConvexView view_of_shape(const Geom& geom, const Pose& pose)
{
    return view_of(static_cast<const ShapeGeom<Shape>&>(geom).shape, pose);
}

// What is thinner than this part of its size counts as so thick.
inline constexpr Real kThinnest = Real(0.01);
inline Real thickness_at_least(Real half, Real size)
{
    return half < kThinnest * size ? kThinnest * size : half;
}

}  // namespace epode
