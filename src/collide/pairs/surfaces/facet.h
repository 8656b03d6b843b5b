// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One facet of a height field against one solid, in the field's frame (y up). The terrain is solid to any
// depth: an endless column stands under each facet. One collector receives the contacts of all facets. A
// contact normal that is not the facet's own must crest there (Terrain::crests): the surface lies below it on
// all sides. Flat and concave edges have no such normal, so a solid that slides over them meets no bumps.
// The walls of missing cells give contacts, too (hole_walls.h).
#pragma once

#include "collide/pairs/contact_collector.h"
#include "collide/pairs/polyhedra/least_axes.h"
#include "collide/pairs/polyhedra/placed_hull.h"
#include "collide/pairs/surfaces/field_corners.h"
#include "collide/pairs/surfaces/hole_walls.h"
#include "collide/pairs/surfaces/on_surface.h"
#include "collide/surfaces/heightfield.h"

namespace epode {

// Horizontal separating axes between columns and a solid that is not round: across the cells' diagonals and
// along their edges. They are the same for all facets, so the solid's extents along them are computed once.
class Sides {
  public:
    Sides(const Terrain& terrain, const ConvexView& solid, Real slack);
    bool reach(const Facet& facet) const  // of the facet its corners only
    {
        for (int s = 0; s < count_; ++s) {
            const Side& side = sides_[s];
            Real at[3];
            for (int k = 0; k < 3; ++k) at[k] = side.x * facet.v[k].x + side.z * facet.v[k].z;
            const bool before = at[0] < side.lo && at[1] < side.lo && at[2] < side.lo;
            const bool behind = at[0] > side.hi && at[1] > side.hi && at[2] > side.hi;
            if (before || behind) return false;
        }
        return true;
    }

  private:
    struct Side {
        Real x, z, lo, hi;
    };
    void add(Vec3 level, const SolidReach& reach, Real slack);
    static constexpr int kMax = 4;
    Side sides_[kMax];
    int count_ = 0;
};

// One solid and one height field while its facets are visited.
struct TerrainPair {
    const Terrain& terrain;
    const ConvexView& solid;
    Aabb box;    // of the solid
    Real slack;  // rounding of coordinates
    ContactCollector& out;
    HoleWalls* walls = nullptr;       // there are holes under the solid
    PlacedHull* hull = nullptr;       // the solid, if it is a polyhedron
    FieldCorners* corners = nullptr;  // of its hull
    CylinderEnds* ends = nullptr;     // if it is a cylinder

    // A contact whose normal is not the facet's own.
    void add_crest(const Facet& facet, Vec3 at, Vec3 normal, Real depth)
    {
        terrain.ends_at(facet, normal) ? out.add_at_border(at, normal, depth) : out.add(at, normal, depth);
    }
};

inline constexpr Vec3 kUp{0, 1, 0};
inline constexpr Real kSteepest = Real(1e-3);  // least upward part of a contact normal

// A sphere or capsule.
void round_on(const RoundSolid& core, const Facet& facet, TerrainPair& pair);

// A box, a cylinder or a polyhedron, by the view in `pair`.
void solid_on(const Facet& facet, TerrainPair& pair);

// Records in pair.walls whether walls under the facet's edges give the contacts, and not its face.
void weigh_round(const RoundSolid& core, const Facet& facet, TerrainPair& pair);
void weigh_solid(const Facet& facet, TerrainPair& pair);

}  // namespace epode
