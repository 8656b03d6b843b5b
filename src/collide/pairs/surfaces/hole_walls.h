// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Holes of a height field under one solid. The terrain at a hole is a slab with an upright wall in a plane
// w . x = c, where w is one of +-x, +-z of the field and points into the hole. A solid that is in the slab
// and reaches into the hole leaves by the smaller overlap, up over a facet or along w. If w is smaller for a
// facet at the rim, all facets behind that plane (w . v <= c) leave the solid to the wall, so the adjacent
// column does not lift a solid that slides down a shaft. Rejected: the wall as one more normal of each facet,
// because facets of the second row have no wall.
#pragma once

#include "collide/surfaces/heightfield.h"

namespace epode {

class HoleWalls {
  public:
    // `in_hole`: the solid's middle is over a hole.
    HoleWalls(Vec3 middle, bool in_hole) : level_(in_hole ? middle.y : kInf) {}

    // Whether the middle is in the hole, lower than all of the facet. Then only walls give contacts.
    bool sunk(const Facet& f) const { return level_ < f.v[0].y && level_ < f.v[1].y && level_ < f.v[2].y; }

    void push(const Facet& f, int k)
    {
        Real& limit = limit_[way(f, k)];
        limit = f.out_limit(k) > limit ? f.out_limit(k) : limit;
    }
    bool gives_contacts(const Facet& f, int k) const { return f.out_limit(k) <= limit_[way(f, k)]; }
    bool behind(const Facet& f) const
    {
        for (int w = 0; w < 4; ++w) {
            Real farthest = -kInf;
            for (const Vec3 v : f.v) {
                const Real at = w == 0 ? v.x : w == 1 ? -v.x : w == 2 ? v.z : -v.z;
                farthest = at > farthest ? at : farthest;
            }
            if (farthest <= limit_[w]) return true;
        }
        return false;
    }

  private:
    static int way(const Facet& f, int k) { return (k == 0 ? 0 : 2) + (f.upper ? 0 : 1); }

    Real level_;
    Real limit_[4] = {-kInf, -kInf, -kInf, -kInf};  // of the planes whose walls give contacts
};

}  // namespace epode
