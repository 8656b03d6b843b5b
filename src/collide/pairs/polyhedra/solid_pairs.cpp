// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Any solid against another one: convex_convex.cpp. Against a plane n . x <= d: what it shows along -n, each
// point with its own depth d - n . x, and where none of these is deepest, as on a rim, its farthest point.
#include "collide/pairs/solid_pairs.h"

#include "collide/pairs/pairs.h"
#include "collide/solid_type.h"

namespace epode {

void solid_solid(const Geom& a, const Pose& A, const Geom& b, const Pose& B, ContactSink& sink)
{
    convex_convex(solid_view(a, A), solid_view(b, B), sink);
}

void view_plane(const ConvexView& a, const Plane& b, ContactSink& sink)
{
    constexpr Real kDeepest = Real(1e-5);  // of the size: farther below the others it is a contact of its own
    const Real hair = kDeepest * (a.size + a.radius);
    const auto depth_of = [&](Vec3 p) { return b.d - dot(b.normal, p); };
    const Vec3 out = a.radius * b.normal, lowest = a.support(-b.normal) - out;
    const Real depth = depth_of(lowest);
    if (!(depth >= 0)) return;
    Polygon shown;
    a.feature(-b.normal, shown);
    ContactPoint points[Polygon::kMax + 1];
    int count = 0;
    Real deepest = -kInf;
    for (int i = 0; i < shown.count; ++i) {
        const Vec3 p = shown.points[i] - out;
        const Real d = depth_of(p);
        if (!(d >= 0)) continue;
        points[count++] = {p, b.normal, d};
        deepest = d > deepest ? d : deepest;
    }
    if (count == 0 || depth > deepest + hair) points[count++] = {lowest, b.normal, depth};
    sink.add_manifold({points, std::size_t(count)});
}

void solid_plane(const Geom& a, const Pose& A, const Geom& plane, const Pose&, ContactSink& sink)
{
    view_plane(solid_view(a, A), static_cast<const ShapeGeom<Plane>&>(plane).shape, sink);
}

}  // namespace epode
