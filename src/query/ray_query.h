// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays against spaces. A ray meets a geom as dCollide(ray, geom) says, overrides and functions of the program
// included, and of each geom counts the nearest hit. The nearest geom is sought down the tree of the space,
// near boxes first, with a reach that shrinks to the best distance so far; so far from everything is visited,
// and the answer is still that of trying all: boxes are widened by more than rounding, the reach is a little
// more than the best distance, and of equal distances the newer geom wins. What needs a reach that does not
// depend on the shape of the tree waits for the end of the walk and is asked in order of joining: geoms for
// which functions of the program are called, and height fields, whose walk over the grid rounds with its end;
// and all geoms if the filter has a callback.
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

// A ray geom that no space and no pool knows. What functions of the program may do to it is undone.
class RayProbe : public ShapeGeom<Ray> {
  public:
    RayProbe();
    ~RayProbe();
    void aim(const RayQuery& query, Real length);

  private:
    GeomHold hold_{*this};
};

class RayCaster {
  public:
    // `ready`: make_ready() has been called, several threads may ask, and no function of the program is in
    // the way.
    RayCaster(Space& space, bool ready) : space_(space), ready_(ready) {}

    RayAnswer closest(const RayQuery& query);

    // All geoms that are hit, nearest first. False when memory is exhausted.
    [[nodiscard]] bool all(const RayQuery& query, Array<RayAnswer>& out);

    // Is there a geom for which a function of the program would be called?
    bool needs_program();

  private:
    template <typename Found>
    void walk(Space& space, const RayQuery& query, Real& reach, Found&& found);
    template <typename Found>
    void ask_waiting(const RayQuery& query, const Real& reach, Found&& found);
    bool hit(const RayQuery& query, Geom& geom, Real length, RayAnswer& out);

    PairFunction direct(const Geom& geom);
    void aim(const RayQuery& query);

    Space& space_;
    bool ready_;
    RayProbe probe_;
    Pose pose_;  // of the ray: its axis is the third column
    // By class, from numbers that no program's function changes: the pair function, where it may be called at
    // once.
    PairFunction direct_[kGeomClasses];
    unsigned asked_ = 0;  // bits of the classes for which that is known
    Array<Geom*> waiting_;
};

}  // namespace epode
