// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See placed_hull.h.
#include "collide/pairs/polyhedra/placed_hull.h"

namespace epode {

void PlacedHull::find_axes()
{
    known_ = true;
    for (int i = 0; i < 4 * groups(); ++i) {
        const int face = i < count_ ? i : count_ - 1;
        const Vec3 a = view_.pose.R * view_.faces[std::size_t(face)].normal;
        FourFaces& some = faces_[i / 4];
        some.x[i % 4] = a.x, some.y[i % 4] = a.y, some.z[i % 4] = a.z;
        some.low[i % 4] = dot(a, view_.support(-a)), some.high[i % 4] = -dot(-a, view_.support(a));
        sides_[face] = 0;
    }
}

void PlacedHull::polygon(int face, Polygon& out)
{
    const Vec3 outward = axis(face);
    if (sides_[face] > 0) {
        for (int k = 0; k < sides_[face]; ++k) out.add(points_[first_[face] + k]);
        out.normal = normals_[face];
        return;
    }
    view_.feature(outward, out);
    if (out.count > kMostCorners - corners_) return;
    first_[face] = corners_, sides_[face] = out.count, normals_[face] = out.normal;
    for (int k = 0; k < out.count; ++k) points_[corners_++] = out.points[k];
}

}  // namespace epode
