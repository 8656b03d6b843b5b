// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The manifold of a box, cylinder or polyhedron that is pushed out along a facet's own normal: its faces that
// look at the facet, its true rims' lowest points, and where the rims pass over edges at which the patch may
// end. What becomes of a piece of the solid is the ground's to say:
//   ground.press(polygon)   cuts by the facet's prism and keeps what is deep; of a point the same
//   ground.ends_at(edge)    may a contact patch end there?
//   ground.upright()         the direction of the prism
#pragma once

#include <type_traits>

#include "geometry/triangle.h"

namespace epode {

inline constexpr Real kFaceLean = Real(0.17);  // faces that look down by more than 10 degrees carry contacts
inline constexpr Real kFlat = kSingle ? Real(1e-4) : Real(1e-6);  // lean of a rim that has no lowest point

template <typename Ground>
class Press {
  public:
    Press(const ConvexView& solid, const Triangle& facet, Ground& ground) : s_(solid), f_(facet), to_(ground)
    {}

    void all()
    {
        for (const PolyhedronFace& own : s_.faces) face(s_.pose.R * own.normal);
        for (int i = 0; i < 3; ++i) {
            if (!(s_.face_axes >> i & 1)) continue;
            const Vec3 axis = s_.pose.R.column(i);
            face(dot(axis, f_.n) > 0 ? -axis : axis);
        }
        if (!s_.faces.empty()) to_.press(s_.support(-f_.n));
        if (s_.rim_radius > 0) round();
    }

  private:
    void face(Vec3 outward)
    {
        if (-dot(outward, f_.n) >= kFaceLean) feature(outward);
    }

    void feature(Vec3 direction)
    {
        Polygon polygon;
        s_.feature(direction, polygon);
        to_.press(polygon);
    }

    void round()
    {
        const Vec3 axis = s_.pose.R.column(2);
        const Vec3 aside = dot(axis, f_.n) * axis - f_.n;
        if (length2(aside) > kFaceLean * kFaceLean) feature(aside);
        // The lowest of the true rim, not of its polygon; the support of a flat end is its middle.
        if (length2(aside) > kFlat * kFlat) to_.press(s_.support(-f_.n));
        // The support of an end is its middle only to rounding: of a wheel that has rolled, a point of the
        // rim.
        for (const Vec3 end : {axis, -axis})
            rim(axis, s_.pose.p + dot(s_.support(end) - s_.pose.p, end) * end);
    }

    // Where the true rim passes over the facet's edges: on a ridge, these are the deepest points.
    void rim(Vec3 axis, Vec3 centre)
    {
        const Real r = s_.rim_radius;
        for (int k = 0; k < 3; ++k) {
            if (!to_.ends_at(k)) continue;
            Vec3 wall = cross(f_.edge(k), to_.upright());
            const Real offset = dot(wall, f_.v[k] - centre);
            wall -= dot(wall, axis) * axis;  // within the plane of the end
            const Real steep = length(wall), s = offset / steep;
            if (!(std::fabs(s) < r)) continue;
            const Vec3 out = wall / steep, along = std::sqrt(r * r - s * s) * cross(axis, out);
            to_.press(centre + s * out + along);
            to_.press(centre + s * out - along);
        }
    }

    const ConvexView& s_;
    const Triangle& f_;
    Ground& to_;
};

template <typename Ground>
void press_solid(const ConvexView& solid, const Triangle& facet, Ground ground)
{
    Press<std::remove_reference_t<Ground>>(solid, facet, ground).all();
}

}  // namespace epode
