// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The directions across an edge of a solid and the three edges of a triangle, side by side: lane k is that of
// edge k, the fourth repeats the third. Of most of them what is known to be in the solid, a point and a ball,
// shows that they are worth nothing. They are not unit vectors: what is compared with a length is its square
// with its sign, so that no root is taken. All is in an unnamed namespace for the reason given in
// simd/pack.h.
#pragma once

#include "geometry/triangle.h"
#include "simd/quad.h"

namespace epode {
namespace {

class AcrossEdges {
  public:
    AcrossEdges(Vec3 axis, const Triangle& f)
    {
        const Vec3 a = f.edge(0), b = f.edge(1), c = f.edge(2);
        const Quad ex = quad(a.x, b.x, c.x, c.x), ey = quad(a.y, b.y, c.y, c.y),
                   ez = quad(a.z, b.z, c.z, c.z);
        x_ = quad(axis.y) * ez - quad(axis.z) * ey;
        y_ = quad(axis.z) * ex - quad(axis.x) * ez;
        z_ = quad(axis.x) * ey - quad(axis.y) * ex;
        size2_ = x_ * x_ + y_ * y_ + z_ * z_;
    }
    Quad along(Vec3 v) const { return x_ * quad(v.x) + y_ * quad(v.y) + z_ * quad(v.z); }
    const Quad& rise() const { return y_; }

    // The triangle's reach along them and against them, from a point.
    struct Reach {
        Quad largest, least;
    };
    Reach reach(const Triangle& f, Vec3 from) const
    {
        const Quad p = along(f.v[0] - from), q = along(f.v[1] - from), r = along(f.v[2] - from);
        return {larger(larger(p, q), r), smaller(smaller(p, q), r)};
    }

    // Where d, which is times the direction's length, is more than the bound; a bit for each.
    unsigned beyond(const Quad& d, Real bound) const
    {
        return bits(quad(bound * std::fabs(bound)) * size2_ < d * magnitude(d));
    }
    unsigned at_least(const Quad& d, Real bound) const { return bits(quad(bound * bound) * size2_ <= d * d); }

  private:
    Quad x_, y_, z_, size2_;
};

}  // namespace
}  // namespace epode
