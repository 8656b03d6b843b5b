// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The directions in which a polyhedron and a triangle, or the column under one, overlap least besides the
// triangle's own normal: those of the faces of their Minkowski difference. They are opposite the polyhedron's
// faces, and across an edge e of the triangle and an edge h of the polyhedron whose arcs cross on the Gauss
// map: the plane across e divides the normals of the two faces at h, and the direction is the one across both
// on the outer side of e. Of all products of edges these are the few that can be least; all others overlap by
// more. All but the last few are known by the distances of the triangle's corners from the polyhedron's faces.
#pragma once

#include <algorithm>

#include "collide/pairs/polyhedra/placed_hull.h"
#include "geometry/triangle.h"

namespace epode {
namespace {

class HullAxes {
  public:
    // `upward`: only directions that are not downward count, the triangle stands for its column.
    HullAxes(PlacedHull& hull, const Triangle& f, bool upward) : hull_(hull), f_(f), upward_(upward)
    {
        hull_.place();
        const QuadPlane v[3] = {QuadPlane(f.v[0]), QuadPlane(f.v[1]), QuadPlane(f.v[2])};
        for (int k = 0; k < 3; ++k) {
            Real* const distances = hull_.face_scratch(k);
            for (int g = 0; g < hull_.face_groups(); ++g) {
                const Real* const four = hull_.faces(g);
                store_quad(distances + 4 * g, v[k].along(four) - load_quad(four + 12));
            }
            out_[k] = distances;
        }
    }
    // The distances of the triangle's corners from the faces are known.
    HullAxes(PlacedHull& hull, const Triangle& f, bool upward, const Real* a, const Real* b, const Real* c)
        : hull_(hull), f_(f), upward_(upward), out_{a, b, c}
    {}

    // offer(n, overlap) of directions in which the overlap is less than `worth`; false where one of them
    // parts the two by more than the slack.
    template <typename Offer>
    bool faces(Real worth, Real slack, const Offer& offer) const
    {
        for (int g = 0; g < hull_.face_groups(); ++g) {
            const Real* const four = hull_.faces(g);
            const Quad at[3] = {load_quad(out_[0] + 4 * g), load_quad(out_[1] + 4 * g),
                                load_quad(out_[2] + 4 * g)};
            const Quad overlap = quad(0) - smaller(smaller(at[0], at[1]), at[2]);
            unsigned some = bits(overlap < quad(worth));
            if (upward_) some &= bits(load_quad(four + 4) <= quad(0));
            if (some && some & bits(overlap < quad(-slack))) return false;
            for (; some; some &= some - 1) {
                const int i = __builtin_ctz(some);
                offer(-Vec3{four[i], four[4 + i], four[8 + i]}, lane(overlap, i));
            }
        }
        return true;
    }

    // offer(n, overlap, edge) as above across edges, of the triangle's those that have a bit in `which`. What
    // is worth nothing offers do not make worth more, so the worth is that of the beginning.
    template <typename Offer>
    bool edges(unsigned which, Real worth, Real slack, const Offer& offer)
    {
        if (which == 0) return true;
        if (!leans_known_) find_leans();
        const unsigned char* const side = hull_.face_marks();
        for (const PolyhedronEdge& seam : hull_.seams()) {
            for (unsigned some = (side[seam.left] ^ side[seam.right]) & which; some; some &= some - 1) {
                const int k = __builtin_ctz(some);
                if (overlaps_more(seam, k, worth)) continue;
                Vec3 n;
                Real overlap;
                if (!least_across(seam, k, n, overlap)) continue;
                if (overlap < -slack) return false;
                if (overlap < worth) offer(n, overlap, k);
            }
        }
        return true;
    }

  private:
    // Of each face a bit for every edge of the triangle that its normal leans along.
    void find_leans()
    {
        leans_known_ = true;
        for (int g = 0; g < hull_.face_groups(); ++g) {
            const Quad at[3] = {load_quad(out_[0] + 4 * g), load_quad(out_[1] + 4 * g),
                                load_quad(out_[2] + 4 * g)};
            store_bytes(hull_.face_marks() + 4 * g, byte_each(bits(at[0] < at[1])) |
                                                        byte_each(bits(at[1] < at[2])) << 1 |
                                                        byte_each(bits(at[2] < at[0])) << 2);
        }
    }

    // Whether the direction between those opposite the two faces is not on the outer side of edge k, or
    // downward, or worth nothing. With l and r the normals and a, b the rises of the edge over the two faces,
    // it is along -(|b| l + |a| r), and the overlaps of the edge and of the third corner are the same sums of
    // their distances.
    bool overlaps_more(const PolyhedronEdge& seam, int k, Real worth) const
    {
        const int l = seam.left, r = seam.right;
        const Real *const here = out_[k], *const next = out_[k < 2 ? k + 1 : 0],
                          *const third = out_[k > 0 ? k - 1 : 2];
        const Real of_r = std::fabs(next[l] - here[l]), of_l = std::fabs(next[r] - here[r]);
        const Real cosine = 2 * seam.cos_half * seam.cos_half - 1;
        const Real size2 = of_l * of_l + of_r * of_r + 2 * of_l * of_r * cosine;
        if (size2 <= kUnsure * (of_l * of_l + of_r * of_r)) return false;
        const Real overlap = -(of_l * here[l] + of_r * here[r]);
        if (overlap < -(of_l * third[l] + of_r * third[r])) return true;
        if (upward_ && of_l * hull_.normal(l).y + of_r * hull_.normal(r).y > 0) return true;
        return overlap > 0 && overlap * overlap >= worth * worth * size2;
    }

    // The same to rounding, a unit vector; false where there is no such direction.
    bool least_across(const PolyhedronEdge& seam, int k, Vec3& n, Real& overlap) const
    {
        const Vec3 from = hull_.corner(seam.from), h = hull_.corner(seam.to) - from, e = f_.edge(k);
        const Vec3 aside = cross(h, hull_.normal(seam.left));  // along the left face, out of it
        n = cross(h, e);
        if (dot(n, aside) > 0) n = -n;
        if (dot(n, cross(e, f_.n)) < 0 || (upward_ && n.y < 0)) return false;
        const Real size2 = length2(n);
        if (size2 <= Real(1e-6) * length2(h) * length2(e)) return false;
        n = n / std::sqrt(size2);
        overlap = dot(n, f_.v[k] - from);
        return true;
    }

    static constexpr Real kUnsure = kSingle ? Real(1e-4) : Real(1e-8);  // of sums of squares that cancel

    PlacedHull& hull_;
    const Triangle& f_;
    const bool upward_;
    bool leans_known_ = false;
    const Real* out_[3];  // of each corner of the triangle its distances from the faces, outwards
};

}  // namespace
}  // namespace epode
