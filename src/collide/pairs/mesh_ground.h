// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What becomes of a solid that is pushed out along a facet's own normal n: of every face of it that looks at
// the facet the corners of its common part with the facet's prism, each a contact of its own depth. Such a
// corner is
//   a corner of the face          in the prism
//   on an edge of the face        where it goes through a wall of the prism
//   over a corner of the triangle in the face
// Where a wall stands on a seam the patch goes on in the neighbour: what it cuts is no contact. Heights and
// distances from the walls are linear, so each is reckoned once for every corner, and what is above the facet
// is done with. Cutting the face wall by wall (Sutherland and Hodgman 1974) makes the same points and many
// that are above.
#pragma once

#include "collide/pairs/mesh_patch.h"

namespace epode {

// Where a point is: above the facet, and beyond the walls.
struct PrismPlace {
    Real height, beyond[3];
};

class MeshGround {
  public:
    MeshGround(const MeshFacet& facet, MeshMeeting& meeting) : f_(facet), m_(meeting), prism_(facet) {}

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
    bool low(Real height) const { return height <= m_.slack; }
    bool within(const PrismPlace& a) const
    {
        return a.beyond[0] <= m_.slack && a.beyond[1] <= m_.slack && a.beyond[2] <= m_.slack;
    }

    void press(const Polygon& face);
    void press(Vec3 p)
    {
        if (const PrismPlace at = place(p); low(at.height) && within(at)) give(p);
    }
    void press_edge(Vec3 p, const PrismPlace& at_p, Vec3 q, const PrismPlace& at_q);
    void give(Vec3 p)
    {
        if (held_ >= 0 && held_ < kMostHeld)
            holds_[held_++] = p;
        else
            put(p);
    }

    // From now on contacts are held back until deliver(), as far as there is room.
    void hold() { held_ = 0; }
    int held() const { return held_; }
    // Whether one of them shows that the triangle is met: the way to it from the solid's middle, which is
    // above, goes through.
    bool met() const;
    void deliver()
    {
        for (int i = 0; i < held_; ++i) put(holds_[i]);
    }
    // A corner of the triangle is where two walls meet; the later of them has the word.
    bool corner_counts(int corner) const { return ends_at(corner == 1 ? 1 : 2); }

    bool ends_at(int edge) const { return !(m_.whole && prism_.seam[edge]); }
    Vec3 upright() const { return f_.n; }
    Real slack() const { return m_.slack; }

  private:
    static constexpr int kMostHeld = 64;  // a cylinder has less
    void press_corners(const Polygon& face);
    void put(Vec3 p)
    {
        const Real depth = -f_.height(p);
        m_.out.add(p, f_.n, depth > 0 ? depth : 0, f_.index);
    }

    const MeshFacet& f_;
    MeshMeeting& m_;
    const Prism prism_;
    int held_ = -1;
    union {
        Vec3 holds_[kMostHeld];  // in a union: left unwritten until held
    };
};

// A box, by the view in `meeting`.
void press_box(const Box& box, const MeshFacet& facet, MeshMeeting& meeting);

}  // namespace epode
