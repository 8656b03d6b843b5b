// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The support point of a core with a radius r is that of the core and r times the direction further out; so
// is all of what it shows that way.
#include "collide/any_solid.h"

namespace epode {
namespace {

const ConvexView& core_of(const void* shape) { return static_cast<const AnySolid*>(shape)->core; }

Vec3 support(const void* shape, Vec3 direction)
{
    const ConvexView& core = core_of(shape);
    return core.support(direction) + core.radius * normalized_or(direction, {});
}

void feature(const void* shape, Vec3 direction, Polygon& out)
{
    const ConvexView& core = core_of(shape);
    const int first = out.count;
    core.feature(direction, out);
    const Vec3 further = core.radius * normalized_or(direction, {});
    for (int i = first; i < out.count; ++i) out.points[i] += further;
}

}  // namespace

ConvexView view_of(const AnySolid& solid, const Pose& pose)
{
    ConvexView view = solid.core;
    view.pose = pose * solid.core.pose;
    if (solid.core.radius == 0) return view;
    return {.shape = &solid,
            .kind = SolidKind::kCurved,
            .local_support = support,
            .local_feature = feature,
            .pose = pose,
            .size = length(solid.core.pose.p) + solid.core.size + solid.core.radius};
}

}  // namespace epode
