// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contacts of a polyhedron with a facet (facet_contacts.h). Heights over the facet and distances from the
// walls of its prism are computed once for every corner, four at a time; then each edge is looked at once, by
// what is known of its ends.
#include "collide/pairs/polyhedra/placed_hull.h"
#include "collide/pairs/surfaces/facet_contacts.h"
#include "collide/pairs/surfaces/facet_manifold_builder.h"

namespace epode {

namespace {

// Marks of a corner: behind the walls of the prism, low, and on a face that looks down at the facet.
constexpr unsigned kIn = 7, kLow = 8, kShown = 16;

class HullManifoldBuilder {
  public:
    HullManifoldBuilder(PlacedHull& hull, const Triangle& facet, FacetContacts& to)
        : h_(hull), f_(facet), to_(to), marks_(hull.corner_marks()), height_(hull.scratch(0))
    {
        h_.place();
        for (int k = 0; k < 3; ++k) beyond_[k] = h_.scratch(1 + k);
    }

    void all()
    {
        if (!place_heights()) return;
        place_walls();
        find_shown_faces();
        edges();
        for (const int g : h_.corner_groups())
            for (int i = 4 * g; i < 4 * g + 4; ++i)
                if (marks_[i] == (kIn | kLow | kShown)) to_.give(h_.corner(i));
        for (int k = 0; k < 3; ++k)
            if (crossed_[k] && crossed_[(k + 2) % 3] && to_.corner_counts(k)) triangle_corner(k);
    }

  private:
    // False when no corner is low.
    bool place_heights()
    {
        const QuadPlane n(f_.n);
        const Quad c = quad(f_.c);
        Quad least = quad(kInf);
        for (const int g : h_.corner_groups()) {
            const Quad height = n.along(h_.corners(g)) - c;
            store_quad(height_ + 4 * g, height);
            least = smaller(height, least);
        }
        lowest_ = -largest_lane(quad(0) - least);
        return to_.low(lowest_);
    }

    // The lowest corner counts, whatever faces it is of.
    void place_walls()
    {
        const QuadPlane out[3] = {QuadPlane(to_.wall(0)), QuadPlane(to_.wall(1)), QuadPlane(to_.wall(2))};
        const Quad slack = quad(to_.slack());
        Quad farthest[3] = {quad(-kInf), quad(-kInf), quad(-kInf)};
        for (const int g : h_.corner_groups()) {
            std::uint32_t marks = byte_each(bits(load_quad(height_ + 4 * g) <= slack)) * kLow;
            for (int k = 0; k < 3; ++k) {
                const Quad beyond = out[k].along(h_.corners(g)) - quad(to_.wall_limit(k));
                store_quad(beyond_[k] + 4 * g, beyond);
                farthest[k] = larger(beyond, farthest[k]);
                marks |= byte_each(bits(beyond <= slack)) << k;
            }
            store_bytes(marks_ + 4 * g, marks);
        }
        for (int k = 0; k < 3; ++k) crossed_[k] = largest_lane(farthest[k]) > 0;
        for (const int g : h_.corner_groups())
            for (int i = 4 * g; i < 4 * g + 4; ++i)
                if (height_[i] <= lowest_) {
                    marks_[i] |= kShown;
                    return;
                }
    }

    void find_shown_faces()
    {
        const QuadPlane n(f_.n);
        for (int g = 0; g < h_.face_groups(); ++g)
            store_bytes(h_.face_marks() + 4 * g, byte_each(bits(n.along(h_.faces(g)) <= quad(-kFaceLean))));
    }

    // Where those of faces that look down go through a wall.
    void edges()
    {
        const unsigned char* const shown = h_.face_marks();
        unsigned ends = 0;
        for (int k = 0; k < 3; ++k) ends |= to_.ends_at(k) ? 1u << k : 0;
        for (int i = 0; i < h_.seams(); ++i) {
            const PolyhedronEdge& seam = h_.seam(i);
            if (!(shown[seam.left] | shown[seam.right])) continue;
            const unsigned from = marks_[seam.from], to = marks_[seam.to];
            marks_[seam.from] |= kShown, marks_[seam.to] |= kShown;
            if (!((from | to) & kLow)) continue;
            for (unsigned some = (from ^ to) & ends; some; some &= some - 1)
                cross_wall(__builtin_ctz(some), seam.from, seam.to);
        }
    }

    void cross_wall(int k, int v, int w)
    {
        const Real at_v = beyond_[k][v], at_w = beyond_[k][w];
        if (at_v >= 0 && at_w >= 0) return;  // an end on the wall is itself
        const Real t = at_v / (at_v - at_w);
        const auto between = [&](const Real* at) { return at[v] + t * (at[w] - at[v]); };
        if (!to_.low(between(height_)) || between(beyond_[(k + 1) % 3]) > to_.slack() ||
            between(beyond_[(k + 2) % 3]) > to_.slack())
            return;
        const Vec3 p = h_.corner(v);
        to_.give(p + t * (h_.corner(w) - p));
    }

    // Not zero: what is divided by it counts only where it was not.
    EPODE_LANEWISE static Quad usable(const Quad& way)
    {
        return if_less(quad(0), magnitude(way), way, quad(1));
    }

    // A corner of the facet that is in the polyhedron or over it is brought down onto the face by which the way
    // down leaves.
    void triangle_corner(int k)
    {
        const Vec3 v = f_.v[k], up = to_.upright();
        const Real depth = depth_below(v, up);
        if (depth >= -to_.slack() && enters_before(v, up, depth) && leaves_by_shown(v, up, depth))
            to_.give(v - depth * up);
    }

    // How far down the way leaves the polyhedron, if it is in it; no face that is left out looks down.
    Real depth_below(Vec3 v, Vec3 up) const
    {
        const QuadPlane at(v), rise(up);
        Quad leaves = quad(kInf);
        for (int g = 0; g < h_.face_groups(); ++g) {
            const Real* const four = h_.faces(g);
            const Quad out = at.along(four) - load_quad(four + 12), way = rise.along(four);
            leaves = smaller(if_less(way, quad(0), out / usable(way), quad(kInf)), leaves);
        }
        return -largest_lane(quad(0) - leaves);
    }

    // Whether it enters the polyhedron before that depth.
    bool enters_before(Vec3 v, Vec3 up, Real depth) const
    {
        const QuadPlane at(v), rise(up);
        const Quad none = quad(0);
        for (int g = 0; g < h_.all_face_groups(); ++g) {
            const Real* const four = h_.faces(g);
            const Quad way = rise.along(four);
            const unsigned up_or_aside = bits(none <= way);
            if (!up_or_aside) continue;
            const Quad out = at.along(four) - load_quad(four + 12);
            const unsigned later = bits(none < way) & bits(quad(depth) < out / usable(way));
            const unsigned aside = bits(none < out) & bits(way <= none);
            if ((later | aside) & up_or_aside) return false;
        }
        return true;
    }

    bool leaves_by_shown(Vec3 v, Vec3 up, Real depth) const
    {
        const QuadPlane at(v), rise(up);
        for (int g = 0; g < h_.face_groups(); ++g) {
            const Real* const four = h_.faces(g);
            const Quad way = rise.along(four), down = (at.along(four) - load_quad(four + 12)) / usable(way);
            for (unsigned by = bits(way < quad(0)) & bits(down <= quad(depth)); by; by &= by - 1)
                if (h_.face_marks()[4 * g + __builtin_ctz(by)]) return true;
        }
        return false;
    }

    PlacedHull& h_;
    const Triangle& f_;
    FacetContacts& to_;
    unsigned char* const marks_;
    Real *const height_, *beyond_[3], lowest_ = 0;
    bool crossed_[3];
};

}  // namespace

void collect_hull_contacts(PlacedHull& hull, const Triangle& face, FacetContacts& contacts)
{
    HullManifoldBuilder(hull, face, contacts).all();
}

}  // namespace epode
