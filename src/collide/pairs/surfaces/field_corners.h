// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is known of a solid at the corners of a height field's cells: of a polyhedron their distances from its
// faces and the way down from them, of a cylinder where they are on its flat ends. Six facets meet at a corner
// and all need the same numbers. The last corners are kept, by their place modulo 4 x 2: while the facets of a
// row of cells are visited, at most four columns wide, each is computed once.
#pragma once

#include <algorithm>

#include "collide/pairs/polyhedra/way_down.h"
#include "collide/pairs/surfaces/facet_contacts.h"
#include "collide/surfaces/heightfield.h"

namespace epode {

// Where a corner of a facet is in the grid.
struct CornerPlace {
    int i, j;
    CornerPlace(const Facet& f, int k)
        : i(f.i + (f.upper ? k != 2 : k == 2)), j(f.j + (f.upper ? k != 1 : k == 1))
    {}
    int among(int columns) const { return (i & (columns - 1)) + columns * (j & 1); }
};

class FieldCorners {
  public:
    // After PlacedHull::keep_for_field(), if that is called at all.
    FieldCorners(PlacedHull& hull, Real slack) : hull_(hull), slack_(slack)
    {
        hull.place();
        // The rows that the hull has for one facet's corners are free, and the longer the fewer faces are left.
        const int row = std::max(4 * hull.face_groups(), 1);
        const int first = 12 * hull.all_face_groups() / row, rows = first + kNumbers / row;
        columns_ = rows >= 8 ? 4 : rows >= 4 ? 2 : 0;
        for (int i = 0; i < 2 * columns_; ++i)
            places_[i].distances = i < first ? hull.face_scratch(0) + row * i : numbers_ + row * (i - first);
    }
    FieldCorners(const FieldCorners&) = delete;
    FieldCorners& operator=(const FieldCorners&) = delete;
    // Not of a polyhedron of very many faces.
    bool there() const { return columns_ > 0; }

    // Of corner k of a facet.
    const Real* distances(const Facet& f, int k) { return place_of(f, k).distances; }
    // Null where it misses the polyhedron.
    const WayDown* way_down(const Facet& f, int k)
    {
        Place& p = place_of(f, k);
        if (p.below == Below::kUnknown)
            p.below =
                p.way.find(hull_, f.v[k], {0, 1, 0}, slack_, p.distances) ? Below::kFound : Below::kMissed;
        return p.below == Below::kFound ? &p.way : nullptr;
    }

  private:
    static constexpr int kNumbers = 160;
    enum class Below : unsigned char { kUnknown, kFound, kMissed };
    struct Place {
        bool known = false;
        Below below;
        int i, j;
        Real* distances;
        WayDown way;
    };

    Place& place_of(const Facet& f, int k)
    {
        const CornerPlace at(f, k);
        Place& p = places_[at.among(columns_)];
        if (p.known && p.i == at.i && p.j == at.j) return p;
        p.known = true, p.i = at.i, p.j = at.j, p.below = Below::kUnknown, p.way = {};
        const QuadPlane v(f.v[k]);
        for (int g = 0; g < hull_.face_groups(); ++g) {
            const Real* const four = hull_.faces(g);
            store_quad(p.distances + 4 * g, v.along(four) - load_quad(four + 12));
        }
        return p;
    }

    PlacedHull& hull_;
    Real slack_;
    int columns_ = 0;
    Place places_[8];
    union {
        Real numbers_[kNumbers];  // in a union: left unwritten until computed
    };
};

// The flat ends of a cylinder, as the polygons that stand for them: the same for all facets.
class CylinderEnds {
  public:
    CylinderEnds(const ConvexView& cylinder, Real slack) : cylinder_(cylinder), slack_(slack) {}
    CylinderEnds(const CylinderEnds&) = delete;
    CylinderEnds& operator=(const CylinderEnds&) = delete;

    // The end that looks along the axis, or the other.
    const Disc& disc(bool along)
    {
        Disc& d = discs_[along];
        if (d.face.count > 0) return d;
        const Vec3 axis = cylinder_.pose.R.column(2);
        cylinder_.feature(along ? axis : -axis, d.face);
        for (int i = 0; i < d.face.count && i < kRimPoints; ++i)
            d.x[i] = d.face.points[i].x, d.y[i] = d.face.points[i].y, d.z[i] = d.face.points[i].z;
        return d;
    }

    // Where corner k of a facet, brought straight down, is on that end; null where it is not.
    const Vec3* under_corner(bool along, const Facet& f, int k)
    {
        const CornerPlace at(f, k);
        Place& p = places_[along][at.among(4)];
        if (p.state == State::kUnknown || p.i != at.i || p.j != at.j) {
            p.i = at.i, p.j = at.j;
            p.state =
                brought_down(discs_[along].face, f.v[k], {0, 1, 0}, slack_, p.at) ? State::kOn : State::kOff;
        }
        return p.state == State::kOn ? &p.at : nullptr;
    }

  private:
    enum class State : unsigned char { kUnknown, kOn, kOff };
    struct Place {
        State state = State::kUnknown;
        int i, j;
        Vec3 at;
    };
    const ConvexView& cylinder_;
    Real slack_;
    Disc discs_[2];
    Place places_[2][8];
};

// What a facet manifold builder gives the parts of a cylinder to, for a facet of a height field.
class CylinderFacetContacts {
  public:
    CylinderFacetContacts(CylinderEnds& ends, const Facet& facet, FacetContacts& to)
        : ends_(ends), facet_(facet), to_(to)
    {}
    void add_end(bool along)
    {
        const Disc& disc = ends_.disc(along);
        if (disc.face.count != kRimPoints) return to_.add(disc.face);
        if (!to_.add_disc(disc)) return;
        for (int k = 0; k < 3; ++k)
            if (to_.corner_counts(k))
                if (const Vec3* const p = ends_.under_corner(along, facet_, k)) to_.give(*p);
    }
    void add(const Polygon& face) { to_.add(face); }
    void add(Vec3 p) { to_.add(p); }
    bool low(Real height) const { return to_.low(height); }
    bool ends_at(int edge) const { return to_.ends_at(edge); }
    Vec3 wall(int edge) const { return to_.wall(edge); }
    Real before(int edge, Vec3 p) const { return to_.before(edge, p); }

  private:
    CylinderEnds& ends_;
    const Facet& facet_;
    FacetContacts& to_;
};

}  // namespace epode
