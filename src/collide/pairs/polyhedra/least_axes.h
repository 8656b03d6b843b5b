// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the searches for the direction of least overlap between a solid and a facet have in common, of meshes
// (triangle_solid.cpp) and of height fields (facet_solid.cpp): how far a solid goes down along a direction,
// without calls where it is a box or a cylinder; when no direction can be better than the facet's own normal;
// and the axes of a cylinder and a triangle besides that normal. Those of a box are in box_axes.h.
#pragma once

#include <algorithm>

#include "geometry/hulls/polyhedron.h"
#include "geometry/triangle.h"

namespace epode {

inline constexpr Real kFaceFirst = Real(0.95);  // another direction must beat the own normal by this factor

class SolidReach {
  public:
    explicit SolidReach(const ConvexView& solid)
        : solid_(solid),
          box_(solid.face_axes == 7 ? static_cast<const Box*>(solid.shape) : nullptr),
          cylinder_(solid.kind == SolidKind::kCylinder ? static_cast<const Cylinder*>(solid.shape) : nullptr)
    {}
    const Box* box() const { return box_; }
    const Cylinder* cylinder() const { return cylinder_; }

    // n of any length.
    Real low_along(Vec3 n) const
    {
        if (cylinder_) return dot(n, solid_.pose.p) - along_cylinder(n);
        if (!box_) return dot(n, solid_.support(-n));
        return dot(n, solid_.pose.p) - dot(abs(transposed_times(solid_.pose.R, n)), box_->half);
    }
    bool symmetric() const { return box_ || cylinder_; }
    bool has_middle() const { return symmetric() || solid_.kind == SolidKind::kPolyhedron; }
    Vec3 middle() const  // a point that is surely in the solid
    {
        if (symmetric()) return solid_.pose.p;
        return solid_.pose.to_world(static_cast<const Polyhedron*>(solid_.shape)->inner());
    }

    // That no direction can be less than `own`, the overlap along the facet's normal n, by kFaceFirst, when
    // the solid's lowest point p is deep in the triangle. With s the distance of its foot from the edges, in
    // the triangle, c the solid's middle, H its height and L how far it is from over p, the overlap along a
    // direction at the angle a from n is at least
    //   own cos a + s sin a          a <= 90 degrees: what p needs
    //   max(own cos a + s sin a, -H cos a - L sin a)    beyond: the same, and what c needs
    // that is min(own, s) and (s H - L own) / sqrt((H + own)^2 + (s + L)^2). `p` is lowest_along(n).
    bool own_is_least(const Triangle& f, Real own, Vec3 p) const
    {
        if (!has_middle() || !(own > 0)) return false;
        const Real worth = kFaceFirst * own;
        Real s = kInf;
        for (int k = 0; k < 3; ++k) {
            const Vec3 e = f.edge(k);
            const Real in = dot(cross(f.n, e), p - f.v[k]);
            if (!(in > 0) || in * in < worth * worth * length2(e)) return false;
            const Real distance = in / length(e);
            s = distance < s ? distance : s;
        }
        const Vec3 c = middle();
        const Real H = f.height(c), fall = H + own, L2 = length2(c - p) - fall * fall;
        const Real L = L2 > 0 ? std::sqrt(L2) : Real(0), clear = s * H - L * own;
        return clear > 0 && clear * clear > worth * worth * (fall * fall + (s + L) * (s + L));
    }

    // The same of the directions in which edge k is the top of the triangle: they turn by an angle a from n
    // to the edge's outward side. With s and S the distances of p and c from the edge, inwards, the overlap
    // is at least the larger of own cos a + s sin a and -H cos a + S sin a, and that is least at an end or
    // where the two are the same, (own S + H s) / sqrt((own + H)^2 + (S - s)^2). `p` is lowest_along(n).
    bool own_is_less(const Triangle& f, int k, Real own, Vec3 p) const
    {
        const Vec3 c = middle();
        const Real H = f.height(c), worth = kFaceFirst * own;
        const Vec3 e = f.edge(k), in = cross(f.n, e);
        const Real s = dot(in, p - f.v[k]), S = dot(in, c - f.v[k]);  // times the edge's length
        const Real least = own * S + H * s;
        return own > 0 && H > worth && least > 0 &&
               least * least > worth * worth * ((own + H) * (own + H) * length2(e) + (S - s) * (S - s));
    }
    // The edges of which that is not known, a bit for each.
    unsigned edges_to_try(const Triangle& f, Real own, Vec3 p) const
    {
        unsigned some = 0;
        for (int k = 0; k < 3; ++k) some |= own_is_less(f, k, own, p) ? 0 : 1u << k;
        return some;
    }
    Vec3 lowest_along(Vec3 n) const { return solid_.support(-n); }

  private:
    Real along_cylinder(Vec3 n) const
    {
        const Real c = dot(solid_.pose.R.column(2), n), s2 = length2(n) - c * c;
        return cylinder_->half_length * std::fabs(c) + cylinder_->radius * (s2 > 0 ? std::sqrt(s2) : Real(0));
    }

    const ConvexView& solid_;
    const Box* box_;
    const Cylinder* cylinder_;
};

// offer(up, down, size2, axis) until it answers false, which is the answer then, of a cylinder, but for what
// its round and its rims have of directions: its axis, and across that and the triangle's edges.
template <typename Offer>
bool each_cylinder_axis(const Cylinder& cylinder, const Pose& pose, const Triangle& f, Offer&& offer)
{
    const Vec3 axis = pose.R.column(2);
    const Vec3 v[3] = {f.v[0] - pose.p, f.v[1] - pose.p, f.v[2] - pose.p};
    const Real z[3] = {dot(axis, v[0]), dot(axis, v[1]), dot(axis, v[2])};
    const Real least = std::min(std::min(z[0], z[1]), z[2]), largest = std::max(std::max(z[0], z[1]), z[2]);
    const Real half = cylinder.half_length;
    if (!offer(largest + half, half - least, Real(1), [&] { return axis; })) return false;
    for (int k = 0; k < 3; ++k) {
        const Vec3 e = f.edge(k), n = cross(axis, e);
        const Real size2 = length2(n);
        if (size2 <= Real(1e-6) * length2(e)) continue;
        const Real reach = cylinder.radius * std::sqrt(size2);
        const Real on = dot(n, v[k]), off = dot(n, v[k == 0 ? 2 : k - 1]);
        if (!offer(std::max(on, off) + reach, reach - std::min(on, off), size2, [&] { return n; }))
            return false;
    }
    return true;
}

// Its round against the triangle's corners: offer(overlap, normal).
template <typename Offer>
bool each_round_axis(const Cylinder& cylinder, const Pose& pose, const Triangle& f, Offer&& offer)
{
    const Vec3 axis = pose.R.column(2);
    const Vec3 v[3] = {f.v[0] - pose.p, f.v[1] - pose.p, f.v[2] - pose.p};
    for (int k = 0; k < 3; ++k) {
        Vec3 n = dot(v[k], axis) * axis - v[k];
        if (!normalize(n)) continue;
        const Real top = std::max(std::max(dot(n, v[0]), dot(n, v[1])), dot(n, v[2]));
        if (!offer(top + cylinder.radius, n)) return false;
    }
    return true;
}

}  // namespace epode
