// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contacts of a polyhedron with a facet (facet_contacts.h). Heights over the facet and distances from the
// walls of its prism are computed once for every corner, four at a time; then each edge is looked at once, by
// what is known of its ends.
#include "collide/pairs/polyhedra/placed_hull.h"
#include "collide/pairs/surfaces/facet_contacts.h"
#include "collide/pairs/surfaces/facet_manifold_builder.h"
#include "collide/pairs/surfaces/field_corners.h"

namespace epode {

namespace {

// Marks of a corner: behind the walls of the prism, low, and on a face that looks down at the facet.
constexpr unsigned kIn = 7, kLow = 8, kShown = 16;

// The ways down from the corners of a facet.
struct TriangleCorners {
    const PlacedHull& hull;
    const Triangle& face;
    Vec3 up;
    Real slack;
    WayDown way;
    const WayDown* way_down(int k)
    {
        way = {};
        return way.find(hull, face.v[k], up, slack, nullptr) ? &way : nullptr;
    }
};
struct KnownCorners {
    FieldCorners& corners;
    const Facet& facet;
    const WayDown* way_down(int k) { return corners.way_down(facet, k); }
};

template <typename Corners>
class HullManifoldBuilder {
  public:
    HullManifoldBuilder(PlacedHull& hull, const Triangle& facet, FacetContacts& to, const Corners& corners)
        : h_(hull),
          f_(facet),
          to_(to),
          corners_(corners),
          marks_(hull.corner_marks()),
          height_(hull.scratch(0))
    {
        h_.place();
        for (int k = 0; k < 3; ++k) beyond_[k] = h_.scratch(1 + k);
    }

    void all()
    {
        if (!place_heights()) return;
        mark_low_corners();
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

    // Along a wall's normal; most walls of a field's columns are upright to an axis.
    template <int kAxis>
    EPODE_LANEWISE static Quad along(Vec3 out, const Real* four)
    {
        if constexpr (kAxis < 0) return QuadPlane(out).along(four);
        return load_quad(four + 4 * kAxis) * quad(out[kAxis]);
    }
    static int axis_of(Vec3 out)
    {
        return out.y != 0 || (out.x != 0 && out.z != 0) ? -1 : out.z == 0 ? 0 : 2;
    }

    template <int kAxis>
    void place_wall(int k)
    {
        const Vec3 out = to_.wall(k);
        const Quad limit = quad(to_.wall_limit(k)), slack = quad(to_.slack());
        Real* const to = beyond_[k];
        unsigned char* const marks = marks_;
        Quad farthest = quad(-kInf);
        for (const int g : h_.corner_groups()) {
            const Quad beyond = along<kAxis>(out, h_.corners(g)) - limit;
            store_quad(to + 4 * g, beyond);
            farthest = larger(beyond, farthest);
            or_bytes(marks + 4 * g, byte_each(bits(beyond <= slack)) << k);
        }
        crossed_[k] = largest_lane(farthest) > 0;
    }
    static void or_bytes(unsigned char* to, std::uint32_t four)
    {
        std::uint32_t before;
        std::memcpy(&before, to, 4);
        store_bytes(to, before | four);
    }

    void place_walls()
    {
        for (int k = 0; k < 3; ++k) {
            const int axis = axis_of(to_.wall(k));
            axis == 0 ? place_wall<0>(k) : axis == 2 ? place_wall<2>(k) : place_wall<-1>(k);
        }
    }

    // The lowest corner counts, whatever faces it is of.
    void mark_low_corners()
    {
        const Quad slack = quad(to_.slack()), least = quad(lowest_);
        bool shown = false;
        for (const int g : h_.corner_groups()) {
            const Quad height = load_quad(height_ + 4 * g);
            std::uint32_t marks = byte_each(bits(height <= slack)) * kLow;
            if (const unsigned lowest = shown ? 0 : bits(height <= least)) {
                marks |= byte_each(lowest & -lowest) * kShown;
                shown = true;
            }
            store_bytes(marks_ + 4 * g, marks);
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
        unsigned char* const marks = marks_;
        unsigned ends = 0;
        for (int k = 0; k < 3; ++k) ends |= to_.ends_at(k) ? 1u << k : 0;
        for (const PolyhedronEdge& seam : h_.seams()) {
            const unsigned from = marks[seam.from], to = marks[seam.to];
            if (!((from | to) & kLow) || !(shown[seam.left] | shown[seam.right])) continue;
            marks[seam.from] |= kShown, marks[seam.to] |= kShown;  // matters where they are low
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

    // A corner of the facet that is in the polyhedron or over it is brought down onto the face by which the way
    // down leaves.
    void triangle_corner(int k)
    {
        const Vec3 v = f_.v[k], up = to_.upright();
        const WayDown* const way = corners_.way_down(k);
        if (way && way->leaves_by(h_, v, up, h_.face_marks())) to_.give(v - way->depth * up);
    }

    PlacedHull& h_;
    const Triangle& f_;
    FacetContacts& to_;
    Corners corners_;
    unsigned char* const marks_;
    Real *const height_, *beyond_[3], lowest_ = 0;
    bool crossed_[3];
};

}  // namespace

void collect_hull_contacts(PlacedHull& hull, const Triangle& face, FacetContacts& contacts)
{
    using Corners = TriangleCorners;
    const Corners corners{hull, face, contacts.upright(), contacts.slack(), {}};
    HullManifoldBuilder<Corners>(hull, face, contacts, corners).all();
}

void collect_field_contacts(PlacedHull& hull, FieldCorners& corners, const Facet& facet,
                            FacetContacts& contacts)
{
    HullManifoldBuilder<KnownCorners>(hull, facet, contacts, KnownCorners{corners, facet}).all();
}

}  // namespace epode
