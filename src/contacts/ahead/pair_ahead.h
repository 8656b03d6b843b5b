// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where two geoms meet within a step, if nothing but gravity acts on them, and how what is found there is seen from now.
//   slow   at the end of the step
//   swift  before: a step may take them through each other, and at its end they would not touch, or from behind (crossing.h)
//   deep   who lands so fast that it is in by a good part of what it is thick touches with its far side, too; looked at when it was shallow
#pragma once

#include "contacts/ahead/crossing.h"
#include "contacts/ahead/far_points.h"
#include "contacts/ahead/speculative_motion.h"
#include "contacts/contact_pair.h"

namespace epode {

class PairAhead {
  public:
    // `size`: of the smaller one.
    PairAhead(const ContactPair& pair, const PlacedGeom& first, const PlacedGeom& second,
              const SpeculativeMotion& soon, Real size)
        : body1_(pair.body1), body2_(pair.body2), first_(first), second_(second), soon_(soon), size_(size)
    {}

    // Of the smaller one's surface in the frame of the other, in the step; by their present velocities, or with what gravity adds.
    Real present_way() const;
    Real way() const;
    bool is_swift() const { return may_pass(first_.geom, second_.geom, way()); }
    bool may_meet(bool swift) const;  // by their boxes
    Pose first_after(const SpeculativeMotion& time) const { return time.pose(body1_, first_.pose); }
    Pose second_after(const SpeculativeMotion& time) const { return time.pose(body2_, second_.pose); }

    // The contacts where they first meet, as they are then. Returns when.
    SpeculativeMotion find(bool swift, ContactArray& out) const;
    // Who ends the step nearer to the far side of a thin floor leaves it there; on its way it met the near side. Bisects for a time at which
    // it is still shallow: a die of 16 mm falls through 20 mm at 2 m/s otherwise. Returns the time.
    [[gnu::cold]] SpeculativeMotion find_earlier(SpeculativeMotion met, ContactArray& out) const;

    // The place of a contact that has been found after `met`, on the surface of the first.
    void move_to_surface(dContactGeom& c, const SpeculativeMotion& met) const;
    // Points of both that are near there, see far_points.h: what lands on one end may come down at twice the speed.
    void add_far(const Pose& first, const Pose& second, ContactArray& out) const;
    // Who slides along a surface may meet another part of it: contacts with that, as they are now.
    [[gnu::cold]] void add_other_parts(ContactArray& out) const;

    // Where a contact between at1 and at2 that is found after `met` is now: until then the point goes along with the one that moves, see
    // solve/substeps/manifold_kernels.inc.
    Vec3 straight_back(Vec3 at1, Vec3 at2, const SpeculativeMotion& met) const;
    // How far a point of the first there moves against the second, by the velocities of now.
    Vec3 approach(Vec3 at, const SpeculativeMotion& met) const;

  private:
    Real way_at(Vec3 velocity) const;
    Real first_share() const;
    void collide_after(const SpeculativeMotion& time, ContactArray& out) const;
    [[gnu::cold]] void go_back(SpeculativeMotion& met, ContactArray& out) const;
    [[gnu::cold]] void add_expected(dContactGeom c, const SpeculativeMotion& met, ContactArray& out) const;

    const Body *body1_, *body2_;
    const PlacedGeom first_, second_;
    const SpeculativeMotion& soon_;
    const Real size_;
};

}  // namespace epode
