// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Polyhedra under a plane, convex or not. The part of each face below the plane is cut into triangles (p, q, r); with a point o of the
// plane these make tetrahedra of signed volume v = (p - o) . ((q - o) x (r - o)) / 6, and
//
//   V = sum v,   Q = sum v (o + p + q + r) / 4.
//
// The lid that the plane makes needs no faces: its tetrahedra are flat. Faces turn counter-clockwise as seen from outside. The
// plane's point is the one nearest to the origin of the frame, so solids far from it lose no digits if their frame is near.
#pragma once

#include "geometry/immersion/immersed.h"

namespace epode {

class PolygonCut {
  public:
    explicit PolygonCut(const WaterPlane& half) : half_(half), origin_(half.offset * half.normal) {}

    // A convex face of at least three corners, given by at(0) ... at(count - 1).
    template <typename Corner>
    void add_face(int count, Corner&& at)
    {
        Vec3 first, last;
        int kept = 0;
        const auto take = [&](Vec3 corner) {
            if (kept >= 2) add_triangle(first, last, corner);
            if (kept == 0) first = corner;
            last = corner, ++kept;
        };
        Vec3 before = at(count - 1);
        Real height_before = half_.height(before);
        for (int i = 0; i < count; ++i) {
            const Vec3 corner = at(i);
            const Real height = half_.height(corner);
            if ((height <= 0) != (height_before <= 0))
                take(before + (height_before / (height_before - height)) * (corner - before));
            if (height <= 0) take(corner);
            before = corner, height_before = height;
        }
    }

    const Immersed& result() const { return sum_; }

  private:
    void add_triangle(Vec3 p, Vec3 q, Vec3 r)
    {
        const Vec3 a = p - origin_, b = q - origin_, c = r - origin_;
        const Real v = dot(a, cross(b, c)) / 6;
        sum_.volume += v;
        sum_.moment += v * (origin_ + Real(0.25) * (a + b + c));
    }

    WaterPlane half_;
    Vec3 origin_;
    Immersed sum_;
};

Immersed immersed_box(Vec3 half_extent, const WaterPlane& half);

}  // namespace epode
