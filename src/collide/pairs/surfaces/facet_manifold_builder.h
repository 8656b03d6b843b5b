// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The manifold of a box, cylinder or polyhedron along a facet's own normal: the faces that look at the facet,
// the lowest points of curved rims, and the points where rims pass over edges at which the manifold may end.
// The receiver `contacts` decides about each piece of the solid:
//   contacts.add(polygon)           clips by the facet's prism and keeps what is deep; the same for a point
//   contacts.ends_at(edge)          whether a manifold may end there
//   contacts.wall(edge)             the outward normal of the prism there
//   contacts.before(edge, point)    the distance of a point from that wall
//   contacts.low(height)            whether a point at this height above the facet may be a contact
//   contacts.add_end(along)         optional: a flat end of a cylinder, which knows its own
#pragma once

#include <type_traits>

#include "collide/pairs/polyhedra/placed_hull.h"
#include "geometry/triangle.h"

namespace epode {

inline constexpr Real kFaceLean = Real(0.17);  // faces that look down by more than 10 degrees carry contacts
inline constexpr Real kFlat = kSingle ? Real(1e-4) : Real(1e-6);  // lean of a rim that has no lowest point

template <typename Contacts>
class FacetManifoldBuilder {
  public:
    FacetManifoldBuilder(const ConvexView& solid, const Triangle& facet, Contacts& contacts)
        : s_(solid), f_(facet), to_(contacts)
    {}

    void all()
    {
        for (int i = 0; i < 3; ++i) {
            if (!(s_.face_axes >> i & 1)) continue;
            const Vec3 axis = s_.pose.R.column(i);
            const bool along = !(dot(axis, f_.n) > 0);
            face(along ? axis : -axis, along);
        }
        if (s_.kind == SolidKind::kCylinder) round();
        if (s_.kind == SolidKind::kCurved || s_.kind == SolidKind::kPolyhedron) curved();
    }

  private:
    void face(Vec3 outward, [[maybe_unused]] bool along)
    {
        if (!(-dot(outward, f_.n) >= kFaceLean)) return;
        if constexpr (requires { to_.add_end(along); })
            to_.add_end(along);
        else
            feature(outward);
    }

    void feature(Vec3 direction)
    {
        Polygon polygon;
        s_.feature(direction, polygon);
        to_.add(polygon);
    }

    void round()
    {
        const Vec3 axis = s_.pose.R.column(2);
        const Vec3 aside = dot(axis, f_.n) * axis - f_.n;
        if (length2(aside) > kFaceLean * kFaceLean) feature(aside);
        // The lowest of the true rim, not of its polygon; the support of a flat end is its middle.
        if (length2(aside) > kFlat * kFlat) to_.add(s_.support(-f_.n));
        const Real half = static_cast<const Cylinder*>(s_.shape)->half_length,
                   drop = s_.rim_radius * length(aside);
        for (const Vec3 end : {axis, -axis}) {
            const Vec3 centre = s_.pose.p + half * end;
            if (to_.low(f_.height(centre) - drop)) rim(axis, centre);
        }
    }

    // What it shows, and its lowest point, which a polygon for a curve may miss. Of a polyhedron only without
    // memory to place it.
    void curved()
    {
        feature(-f_.n);
        to_.add(s_.support(-f_.n));
    }

    // Where the true rim passes over the facet's edges: on a ridge, these are the deepest points.
    void rim(Vec3 axis, Vec3 centre)
    {
        const Real r = s_.rim_radius;
        for (int k = 0; k < 3; ++k) {
            if (!to_.ends_at(k)) continue;
            const Vec3 out = to_.wall(k), within = out - dot(out, axis) * axis;  // in the plane of the end
            const Real steep2 = length2(within), way = to_.before(k, centre);
            if (!(way * way < r * r * steep2)) continue;
            const Real aside2 = r * r - way * way / steep2;
            const Vec3 foot = centre + way / steep2 * within;
            const Vec3 along = std::sqrt(aside2 > 0 ? aside2 / steep2 : Real(0)) * cross(axis, within);
            to_.add(foot + along);
            to_.add(foot - along);
        }
    }

    const ConvexView& s_;
    const Triangle& f_;
    Contacts& to_;
};

template <typename Contacts>
void build_facet_manifold(const ConvexView& solid, const Triangle& facet, Contacts contacts)
{
    FacetManifoldBuilder<std::remove_reference_t<Contacts>>(solid, facet, contacts).all();
}

}  // namespace epode
