// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A polyhedron at its pose against many facets of a surface. What is the same for all facets is computed
// once, on first use, with the same bits as the view's own functions:
//   axes      the unit normal a of each face and the solid's extent along it, low <= a . x <= high, four
//             faces side by side
//   polygons  of each face what the solid shows along its normal
// Of the first kMostFaces faces; of the others nothing is kept.
#pragma once

#include "geometry/hulls/polyhedron.h"
#include "geometry/triangle.h"
#include "simd/quad.h"

namespace epode {

// Of four faces; the last ones repeat where there are fewer.
struct FourFaces {
    Real x[4], y[4], z[4], low[4], high[4];
    Vec3 axis(int i) const { return {x[i], y[i], z[i]}; }
};

class PlacedHull {
  public:
    static constexpr int kMostFaces = 64, kMostGroups = kMostFaces / 4;

    explicit PlacedHull(const ConvexView& view) : view_(view)
    {
        if (view.kind == SolidKind::kPolyhedron)
            count_ = int(view.faces.size()) < kMostFaces ? int(view.faces.size()) : kMostFaces;
    }
    PlacedHull(const PlacedHull&) = delete;
    PlacedHull& operator=(const PlacedHull&) = delete;

    int count() const { return count_; }  // of faces
    int groups() const { return (count_ + 3) / 4; }
    const FourFaces& faces(int group)
    {
        if (!known_) find_axes();
        return faces_[group];
    }
    Vec3 axis(int face) { return faces(face / 4).axis(face % 4); }
    void polygon(int face, Polygon& out);

  private:
    static constexpr int kMostCorners = 160;

    void find_axes();

    const ConvexView& view_;
    int count_ = 0, corners_ = 0;
    bool known_ = false;
    int first_[kMostFaces], sides_[kMostFaces];  // of the corners; no sides: not computed yet
    union {
        FourFaces faces_[kMostGroups];  // in unions: left unwritten until found
    };
    union {
        Vec3 points_[kMostCorners];
    };
    union {
        Vec3 normals_[kMostFaces];
    };
};

namespace {

// How far the solid and a triangle overlap along the axes of four faces, and against them.
struct FaceOverlaps {
    Quad up, down;
    EPODE_LANEWISE FaceOverlaps(const FourFaces& s, const Triangle& f)
    {
        Quad largest = quad(-kInf), least = quad(kInf);
        for (const Vec3 v : f.v) {
            const Quad at =
                load_quad(s.x) * quad(v.x) + load_quad(s.y) * quad(v.y) + load_quad(s.z) * quad(v.z);
            largest = larger(at, largest), least = smaller(at, least);
        }
        up = largest - load_quad(s.low), down = load_quad(s.high) - least;
    }
};

}  // namespace
}  // namespace epode
