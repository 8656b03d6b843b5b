// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a character may meet in one move: convex solids, half-spaces, and single triangles of meshes and height
// fields, collected once from a box around the whole move. A triangle alone is convex, so whatever a move asks
// is asked of convex obstacles: the distance now, and when a straight path comes as close as the skin. That
// makes each touch known by its face, and an obstacle that is left, one by one, is no obstacle.
//   d     signed distance of the shape from the obstacle, less the skin
//   n     unit, from the obstacle to the shape
//   cast  conservative advancement (query/sweep.h): along u, d is reached no sooner than after d / (-n . u)
#pragma once

#include <algorithm>

#include "base/array.h"
#include "collide/character.h"
#include "query/query_shape.h"

namespace epode {

struct Obstacle {
    enum Kind : std::uint8_t { kSolid, kPlane, kTriangle };
    Geom* geom;
    int side;   // triangle of a mesh, else -1
    int index;  // in the array of its kind
    Kind kind;
    Aabb box;
};

struct Touch {
    int obstacle = -1;     // below 0: none
    Real distance = kInf;  // d; of a cast: along the path
    Vec3 normal, pos;
};

class Surroundings {
  public:
    Surroundings(Geom& self, Vec3 velocity)
        : self_(self), skin_(self.character->settings.skin), velocity_(velocity)
    {}
    Surroundings(const Surroundings&) = delete;
    Surroundings& operator=(const Surroundings&) = delete;

    // All that is near the box. The space has been cleaned. False: out of memory.
    [[nodiscard]] bool collect(Space& space, const Aabb& region);

    int count() const { return obstacles_.size(); }
    const Obstacle& operator[](int i) const { return obstacles_.data()[i]; }

    // Of the shape at `centre`; none beyond `limit`.
    Touch touch(int obstacle, Vec3 centre, Real limit) const;
    // The first that it meets on its way along `motion`; what `ignored` says is not met.
    template <typename Ignored>
    Touch cast(Vec3 centre, Vec3 motion, Ignored&& ignored) const;
    Touch cast(Vec3 centre, Vec3 motion) const
    {
        return cast(centre, motion, [](int) { return false; });
    }
    // The unit normal of the face that a touch lies on, which of an edge need not be that of the touch.
    Vec3 face_normal(const Touch& touch, Vec3 up) const;

    // Shapes closer than this to the skin touch. An edge between two faces of a flat surface is so met before the surface is, with a
    // normal that is turned by up to sqrt(2 tolerance/skin): no more than rounding demands.
    Real tolerance() const { return std::max(Real(1e-4) * skin_, 4 * kEpsilon * reach_); }

  private:
    struct Candidate {
        Real least;
        int obstacle;
    };
    [[nodiscard]] bool add(Geom& geom, const Aabb& region);
    [[nodiscard]] bool add_solid(Geom& geom, const ConvexView& view);
    [[nodiscard]] bool add_triangles(Geom& geom, const QueryShape& shape, const Aabb& region);
    Touch advance(int obstacle, Vec3 centre, Vec3 along, Real from, Real limit) const;
    Real least_way(int obstacle, Vec3 centre, Vec3 along, Real limit) const;
    ConvexView view_at(Vec3 centre) const;
    Aabb box_at(Vec3 centre, Real grown_by) const;
    Separation separation_of(int obstacle, const ConvexView& shape, Real limit) const;
    bool separation_over(const Triangle& t, Vec3 centre, Separation& out) const;
    bool separation_of_capsule(const Triangle& t, Vec3 centre, Separation& out) const;
    Real height_over(const Triangle& t, Vec3 centre) const;

    Geom& self_;
    Real skin_;
    Vec3 velocity_;
    ConvexView view_;
    Vec3 half_;       // of its box
    Real reach_ = 0;  // m, of all that is near from the origin
    Array<Geom*> near_;
    Array<Obstacle> obstacles_;
    Array<ConvexView> solids_;
    Array<Plane> planes_;
    Array<Triangle> triangles_;
    mutable Array<Candidate> candidates_;
};

template <typename Ignored>
Touch Surroundings::cast(Vec3 centre, Vec3 motion, Ignored&& ignored) const
{
    Touch best;
    Vec3 along = motion;
    const Real far = length(motion);
    if (!normalize(along)) return best;
    candidates_.clear();
    for (int i = 0; i < count(); ++i) {
        const Real least = least_way(i, centre, along, far);
        if (least <= far && !ignored(i) && !candidates_.push({least, i})) break;
    }
    for (;;) {  // the one that may be nearest first
        Candidate* next = nullptr;
        for (Candidate& way : candidates_)
            if (way.least < (next ? next->least : best.distance)) next = &way;
        if (!next || next->least > far) break;
        const Real limit = best.obstacle < 0 ? far : best.distance;
        const Touch met = advance(next->obstacle, centre, along, next->least, limit);
        if (met.obstacle >= 0 && met.distance < best.distance) best = met;
        next->least = kInf;
    }
    return best;
}

}  // namespace epode
