// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One move of a character (ode/character.h). The shape keeps a gap, the skin, to everything: what glides along
// a flat surface at that gap never meets the edges between its triangles or boxes. In this order:
//   ride     the ground has moved since the last move, or its surface does, as a belt: the character with it, and turns about up
//   free     what has come closer than the skin moves it out again
//   slide    collide and slide: at each touch the motion loses what leads into the planes met so far, along
//            the crease of two (Fauerby 2003); on ground, walkable planes change only its vertical part
//   climb    at a wall: up, forward, down; if ground lies there, no higher than a step, that is the way
//   stick    ground that falls away is followed down
//   settle   what it stands on, and how that moves
// Ground is walkable by the normal of its face. The normal of a touch on an edge lies between those of the two
// faces, which is where a round foot begins to slip (kFoothold).
#pragma once

#include "characters/surroundings.h"

namespace epode {

struct Body;

class Mover {
  public:
    Mover(Geom& self, Vec3 velocity, Real h);

    // False: out of memory, with nothing moved.
    [[nodiscard]] bool run();
    // The part of `v` that none of the surfaces met is against.
    Vec3 unhindered(Vec3 v) const;

  private:
    static constexpr int kMaxPlanes = 8;

    void ride();
    void turn(const Mat3& by);
    Vec3 belt(Geom& ground, Vec3 pos, Vec3 normal) const;
    [[nodiscard]] bool collect();
    void free();
    Vec3 way_out(Real& deepest);
    Vec3 without_advance(Vec3 motion);
    void slide(Vec3 motion);
    void meet(const Touch& touch, Vec3 motion);
    Vec3 slide_normal(Vec3 n, Vec3 motion) const;
    Vec3 bent(Vec3 motion) const;
    Vec3 along_ground(Vec3 motion, Vec3 n) const;
    bool climb(Vec3& motion);
    void stick();
    void settle();
    void stand_on(const Touch& touch, Vec3 face);
    const Touch& support_at(Vec3 centre);
    bool supports(const Touch& touch, Vec3 face) const;
    bool is_steep(Vec3 n) const { return dot(n, up_) < slope_cos_; }
    Real feet(Vec3 centre) const { return dot(centre, up_) - half_height_ - skin_; }
    void push(const Touch& touch);
    void weigh(bool elsewhere);
    void unload(dGeomID ground);
    Body* body_behind(const Touch& touch) const;

    Geom& self_;
    Character& character_;
    const dCharacterSettings settings_;
    const Vec3 up_, velocity_;
    const Real h_, skin_, slope_cos_, half_height_;
    Real force_left_;  // impulse that may be given to bodies
    Surroundings around_;
    Vec3 start_, at_;
    Real nothing_;    // m, a motion below the rounding of positions
    struct Support {  // found the last time
        Vec3 centre, face;
        Touch touch;
        bool known = false;
    } support_;
    bool grounded_;
    Vec3 plane_[kMaxPlanes];
    int planes_ = 0;
    Array<Vec3> met_;  // normals
};

}  // namespace epode
