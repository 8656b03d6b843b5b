// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contacts of a solid with a facet along the facet's own normal n. Every face of the solid that faces the
// facet is intersected with the facet's prism; each corner of the intersection is a contact with its own
// depth. The prism stands along n, for a height field along the vertical. Such a corner is
//   a corner of the face          in the prism
//   on an edge of the face        where it goes through a wall of the prism
//   over a corner of the triangle in the face
// Where a wall stands on a seam the manifold continues in the neighbour: a point on that wall is no contact.
// Heights and distances from the walls are linear, so each is computed once for every corner, and a corner
// above the facet needs nothing more. Clipping the face wall by wall (Sutherland and Hodgman 1974) makes the
// same points and many that are above.
#pragma once

#include "collide/pairs/surfaces/triangle_part.h"

namespace epode {

class FieldCorners;
struct Facet;

// A polygon that stands for a flat end of a cylinder; its corners coordinate by coordinate, too.
struct Disc {
    Polygon face;
    Real x[kRimPoints], y[kRimPoints], z[kRimPoints];
};

// A corner v of a triangle, brought down along `up` onto a face; false where it misses the face, or the face is
// more than `slack` over it.
bool brought_down(const Polygon& face, Vec3 v, Vec3 up, Real slack, Vec3& out);

// Where a point is: above the facet, and beyond the walls.
struct PrismPlace {
    Real height, beyond[3];
};

class FacetContacts {
  public:
    FacetContacts(const MeshFacet& facet, MeshPair& m)
        : f_(facet), prism_(facet), up_(facet.n), slack_(m.slack), out_(m.out), index_(facet.index)
    {
        for (int k = 0; k < 3; ++k) ends_[k] = !m.seam(facet, k);
    }
    // The prism stands along `up`; behind the edge `shared`, unless it is -1, the manifold continues.
    FacetContacts(const Triangle& face, Vec3 up, int shared, Real slack, ContactCollector& out)
        : f_(face), prism_(face, up), up_(up), slack_(slack), out_(out), index_(-1)
    {
        for (int k = 0; k < 3; ++k) ends_[k] = k != shared;
    }

    PrismPlace place(Vec3 p) const
    {
        return {f_.height(p),
                {dot(prism_.out[0], p) - prism_.limit[0], dot(prism_.out[1], p) - prism_.limit[1],
                 dot(prism_.out[2], p) - prism_.limit[2]}};
    }
    PrismPlace along(Vec3 d) const  // of a difference of points
    {
        return {dot(f_.n, d), {dot(prism_.out[0], d), dot(prism_.out[1], d), dot(prism_.out[2], d)}};
    }
    bool low(Real height) const { return height <= slack_; }
    bool within(const PrismPlace& a) const
    {
        return a.beyond[0] <= slack_ && a.beyond[1] <= slack_ && a.beyond[2] <= slack_;
    }

    void add(const Polygon& face);
    // The same without the triangle's corners; true if it must be looked whether they are over the disc.
    bool add_disc(const Disc& disc);
    void add(Vec3 p)
    {
        if (low(f_.height(p)) && within(place(p))) give(p);
    }
    void add_edge(Vec3 p, const PrismPlace& at_p, Vec3 q, const PrismPlace& at_q);
    void give(Vec3 p)
    {
        if (held_ >= 0 && held_ < kMaxHeld)
            holds_[held_++] = p;
        else
            put(p);
    }

    // Holds contacts back until deliver(), up to kMaxHeld of them.
    void hold() { held_ = 0; }
    int held() const { return held_; }
    // Whether one of them proves that the solid touches the triangle: the segment to it from the solid's
    // middle, which is above, goes through the triangle.
    bool met(Vec3 middle) const;
    void deliver()
    {
        for (int i = 0; i < held_; ++i) put(holds_[i]);
    }
    // A corner of the triangle is where two walls meet; the later of them decides.
    bool corner_counts(int corner) const { return ends_at(corner == 1 ? 1 : 2); }

    bool ends_at(int edge) const { return ends_[edge]; }
    Vec3 wall(int edge) const { return prism_.out[edge]; }
    Real wall_limit(int edge) const { return prism_.limit[edge]; }
    Real before(int edge, Vec3 p) const { return prism_.limit[edge] - dot(prism_.out[edge], p); }
    Vec3 upright() const { return up_; }
    Real slack() const { return slack_; }

  private:
    static constexpr int kMaxHeld = 64;  // a cylinder has less
    struct DiscPlaces;
    void cross_disc(const Disc& disc, const DiscPlaces& at, int i);
    void add_corners(const Polygon& face);
    void put(Vec3 p)
    {
        const Real depth = -f_.height(p);
        out_.add(p, f_.n, depth > 0 ? depth : 0, index_);
    }

    const Triangle& f_;
    const Prism prism_;
    Vec3 up_;
    bool ends_[3];
    Real slack_;
    ContactCollector& out_;
    int index_;
    int held_ = -1;
    union {
        Vec3 holds_[kMaxHeld];  // in a union: left unwritten until held
    };
};

// Adds the contacts of a box, cylinder or polyhedron to `contacts`; `hull`: the placed polyhedron, or null.
void collect_facet_contacts(const ConvexView& solid, PlacedHull* hull, const Triangle& face,
                            FacetContacts& contacts);
void collect_hull_contacts(PlacedHull& hull, const Triangle& face, FacetContacts& contacts);
// The same of a polyhedron with a facet of a height field, upright.
void collect_field_contacts(PlacedHull& hull, FieldCorners& corners, const Facet& facet,
                            FacetContacts& contacts);

}  // namespace epode
