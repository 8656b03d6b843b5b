// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "collide/solid_view.h"

namespace epode {
namespace {

template <typename Shape>
ConvexView view_at(const Geom& geom, const Pose& pose)
{
    return view_of(static_cast<const ShapeGeom<Shape>&>(geom).shape, pose);
}

}  // namespace

bool is_solid(const Geom& geom)
{
    constexpr unsigned kSolids = 1u << dSphereClass | 1u << dBoxClass | 1u << dCapsuleClass |
                                 1u << dCylinderClass | 1u << dConvexClass;
    return geom.type->number < 32 && (kSolids >> geom.type->number & 1) != 0;
}

ConvexView solid_view(const Geom& solid, const Pose& pose)
{
    switch (solid.type->number) {
        case dBoxClass:
            return view_at<Box>(solid, pose);
        case dCapsuleClass:
            return view_at<Capsule>(solid, pose);
        case dCylinderClass:
            return view_at<Cylinder>(solid, pose);
        case dConvexClass:
            return view_at<Convex>(solid, pose);
        default:
            return view_at<Sphere>(solid, pose);
    }
}

}  // namespace epode
