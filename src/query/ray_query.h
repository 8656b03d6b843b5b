// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays against spaces. A ray hits a geom as dCollide(ray, geom) reports, including overrides and functions of
// the program; the nearest hit of each geom counts. The search descends the tree of the space, near boxes
// first, and its reach shrinks to the best distance so far. The result is still that of trying all geoms:
// boxes are widened by more than rounding, the reach is slightly longer than the best distance, and of equal
// distances the newer geom wins. Some geoms need a reach that does not depend on the shape of the tree. They
// wait for the end of the walk and are tested in order of insertion: geoms that call functions of the
// program, height fields (whose walk over the grid rounds with the end of the ray), and all geoms if the
// filter has a callback.
#pragma once

#include "collide/collide.h"
#include "collide/types/registry.h"
#include "query/candidates.h"

namespace epode {

struct RayQuery {
    Vec3 origin, direction;  // unit
    Real length = 0;
    QueryFilter filter;
};

struct RayAnswer {
    const Geom* candidate = nullptr;  // of the space: gives the hit's place in the order; null: no hit
    dContactGeom contact;             // depth: distance; g2: what was hit; side2: its triangle
};

inline bool precedes(const RayAnswer& a, const RayAnswer& b)
{
    if (a.contact.depth != b.contact.depth) return a.contact.depth < b.contact.depth;
    return a.candidate != b.candidate && is_newer(*a.candidate, *b.candidate);
}

// A ray geom outside all spaces and pools, which can never be destroyed. Undoes whatever functions of the program
// do to it.
class RayProbe : public ShapeGeom<Ray> {
  public:
    RayProbe();
    ~RayProbe();
    void aim(const RayQuery& query, Real length);
};

class RayCaster {
  public:
    // `ready`: make_ready() has been called, several threads may cast rays, and no geom calls the program.
    RayCaster(Space& space, bool ready) : space_(space), ready_(ready) {}

    RayAnswer closest(const RayQuery& query);

    // All geoms that are hit, nearest first. False: out of memory.
    [[nodiscard]] bool all(const RayQuery& query, Array<RayAnswer>& out);

    // True if testing some geom calls a function of the program.
    bool needs_program();

  private:
    template <typename Found>
    void walk(Space& space, const RayQuery& query, Real& reach, Found&& found);
    template <typename Found>
    void ask_waiting(const RayQuery& query, const Real& reach, Found&& found);
    bool hit(const RayQuery& query, Geom& geom, Real length, RayAnswer& out);
    bool hit_beyond(const RayQuery& query, Geom& geom, Real length, RayAnswer& out);

    PairFunction direct(const Geom& geom);
    void aim(const RayQuery& query);

    Space& space_;
    bool ready_;
    RayProbe probe_;
    Pose pose_;  // of the ray: its axis is the third column
    // By class: the pair function, if it can be called during the walk. Only for built-in classes.
    PairFunction direct_[kGeomClasses];
    unsigned asked_ = 0;  // a bit for each class whose entry is known
    Array<Geom*> waiting_;
};

}  // namespace epode
