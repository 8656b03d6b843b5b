// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What follows from the view of a solid. With h the support function of the whole, radius included, the box
// is [-h(-e_i), h(e_i)] along each axis of the world, and half the least of h(n) + h(-n) over some directions
// n bounds the radius of the largest ball inside.
#include "collide/solid_type.h"

#include <algorithm>

namespace epode {
namespace {

Real width_along(const ConvexView& view, Vec3 n)
{
    return dot(n, view.support(n) - view.support(-n)) + 2 * view.radius;
}

}  // namespace

Real core_reach_by_view(const Geom& geom, Vec3 direction)
{
    return dot(direction, solid_view(geom, {}).support(direction));
}

CoreSize core_size_by_view(const Geom& geom)
{
    const ConvexView view = solid_view(geom, {});
    return {length(view.pose.p) + view.size, view.radius};
}

Aabb box_by_view(Geom& geom)
{
    const ConvexView view = solid_view(geom, load_pose(geom.position, geom.rotation));
    Aabb box;
    for (int i = 0; i < 3; ++i) {
        Vec3 axis;
        axis.set(i, 1);
        box.lo.set(i, view.support(-axis)[i] - view.radius);
        box.hi.set(i, view.support(axis)[i] + view.radius);
    }
    return box;
}

Real half_thickness_by_view(const Geom& geom)
{
    const ConvexView view = solid_view(geom, {});
    Real least = kInf;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = 0; z <= 1; ++z) {
                Vec3 n{Real(x), Real(y), Real(z)};
                if (normalize(n)) least = std::min(least, width_along(view, n));
            }
    return thickness_at_least(least / 2, view.size + view.radius);
}

}  // namespace epode
