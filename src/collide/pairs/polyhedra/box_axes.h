// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The 12 axes of a box and a triangle besides the triangle's normal (Gottschalk, Lin, Manocha 1996), in the
// box's own frame: across its faces, and across one of its edges and one of the triangle's, along which two
// of the triangle's corners are one. Most axes decide nothing: they are tested four at a time in lanes, and
// few are offered one by one. Support functions, as for polyhedra, take ten times as long. All is in an
// unnamed namespace for the reason given in simd/pack.h.
#pragma once

#include "geometry/triangle.h"
#include "simd/quad.h"

namespace epode {
namespace {

// Overlaps of a solid and the triangle along four axes and against them, times their lengths, the squares of
// these, and the axes' parts upwards (along y).
struct AxisOverlaps {
    Quad up, down, size2, rise;
};
// The result of look() at four axes: which of them separate the two, and which must be offered.
struct AxisVerdict {
    unsigned separating, wanted;  // a bit for each
};

// The box's axes: lanes are corners of the triangle, or the edges that begin there, or axes of the box.
class BoxAxes {
  public:
    BoxAxes(const Box& box, const Pose& pose, const Triangle& f) : box_(box), pose_(pose)
    {
        const Vec3 a = f.v[0] - pose.p, b = f.v[1] - pose.p, c = f.v[2] - pose.p;
        const Quad x = quad(a.x, b.x, c.x, 0), y = quad(a.y, b.y, c.y, 0), z = quad(a.z, b.z, c.z, 0);
        for (int i = 0; i < 3; ++i) {
            const Vec3 column = pose.R.column(i);
            v_[i] = quad(column.x) * x + quad(column.y) * y + quad(column.z) * z;
            edge_[i] = after(v_[i]) - v_[i];
        }
        const Mat3& R = pose.R;
        const Quad rows[3] = {quad(R.row0.x, R.row0.y, R.row0.z, 0), quad(R.row1.x, R.row1.y, R.row1.z, 0),
                              quad(R.row2.x, R.row2.y, R.row2.z, 0)};
        Quad largest = quad(-kInf), least = quad(kInf);
        for (const Vec3 v : {a, b, c}) {
            const Quad at = rows[0] * quad(v.x) + rows[1] * quad(v.y) + rows[2] * quad(v.z);
            largest = larger(at, largest), least = smaller(at, least);
        }
        const Quad half = quad(box.half.x, box.half.y, box.half.z, 0);
        faces_ = {largest + half, half - least, quad(1), rows[1]};
    }

    // False if look() finds a separating axis or offer(up, down, size2, axis) returns false. The axes that
    // look() wants are offered in order. axis() returns the axis in the world.
    template <typename Look, typename Offer>
    bool each(const Look& look, const Offer& offer)
    {
        unsigned wanted[4];
        AxisOverlaps edges[3];
        for (int i = 0; i < 4; ++i) {
            unsigned there = 7;
            if (i > 0) edges[i - 1] = across(i - 1, there);
            const AxisVerdict verdict = look(i > 0 ? edges[i - 1] : faces_);
            if (verdict.separating & there) return false;
            wanted[i] = verdict.wanted & there;
        }
        for (; wanted[0]; wanted[0] &= wanted[0] - 1) {
            const int i = __builtin_ctz(wanted[0]);
            if (!offer(lane(faces_.up, i), lane(faces_.down, i), Real(1), [&] { return pose_.R.column(i); }))
                return false;
        }
        for (int i = 0; i < 3; ++i)
            for (unsigned some = wanted[i + 1]; some; some &= some - 1) {
                const int k = __builtin_ctz(some), j = kNext[i], l = kNext[j];
                const auto axis = [&] {
                    return lane(edge_[j], k) * pose_.R.column(l) - lane(edge_[l], k) * pose_.R.column(j);
                };
                if (!offer(lane(edges[i].up, k), lane(edges[i].down, k), lane(edges[i].size2, k), axis))
                    return false;
            }
        return true;
    }

  private:
    static constexpr int kNext[3] = {1, 2, 0};
    static Quad after(const Quad& a) { return quad(lane(a, 1), lane(a, 2), lane(a, 0), 0); }

    // Across axis i of the box and the edges; `there`: which of them have a length.
    AxisOverlaps across(int i, unsigned& there) const
    {
        const int j = kNext[i], l = kNext[j];
        const Quad aj = quad(0) - edge_[l], al = edge_[j], ei = edge_[i];
        const Quad size2 = aj * aj + al * al;
        there &= ~bits(size2 <= quad(Real(1e-6)) * (size2 + ei * ei));
        const Quad on = aj * v_[j] + al * v_[l], off = aj * after(after(v_[j])) + al * after(after(v_[l]));
        const Quad reach = quad(box_.half[j]) * magnitude(aj) + quad(box_.half[l]) * magnitude(al);
        return {larger(off, on) + reach, reach - smaller(off, on), size2,
                aj * quad(pose_.R.row1[j]) + al * quad(pose_.R.row1[l])};
    }

    const Box& box_;
    const Pose& pose_;
    Quad v_[3], edge_[3];  // along the axes of the box
    AxisOverlaps faces_;
};

}  // namespace
}  // namespace epode
