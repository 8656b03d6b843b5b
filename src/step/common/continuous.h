// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Continuous collision: after a step has moved all bodies, the motion of those that have a geom with
// dContinuousOn and have moved by more than a small share of its thickness is swept. A body that would
// penetrate something too deeply (query/impact.h) stops at the time of impact; it keeps its velocities, and
// the next collision finds the contact.
//   groups      bodies that joints other than contacts connect stop together, or the joints would open
//   carried     a body that meets a moving one that does not stop, slow or kinematic, is carried on by it for
//               the rest of the step, or it would be run over: rigidly (step/common/carriage.h), but without turning where
//               that would swing it, or what joints tie to it, much farther than the carrier's own points move
//   each other  of two swept bodies both stop. A body that meets one that has stopped for another reason is
//               swept again: up to kRounds times, in the order of the islands
// All of this runs on the caller's thread, so that results do not depend on the number of threads, and none
// of it while no geom has dContinuousOn. Rejected: repeating the rest of the step from the time of impact, as
// a step of its own: contacts belong to the program.
#pragma once

#include "base/array.h"
#include "collide/geom.h"
#include "dynamics/island.h"
#include "query/impact.h"
#include "step/common/carriage.h"
#include "step/common/cut_short.h"
#include "step/common/undo.h"

namespace epode {

// Lists that keep their memory from step to step.
struct ContinuousLists {
    Array<Geom*> near;
    struct Pair {
        int first, second;  // geoms of active bodies
    };
    Array<Pair> pairs;
};

class Continuous {
  public:
    Continuous(World& world, const StepUndo& undo, ContinuousLists& lists, CutShort& cut_short, Arena& arena,
               Real h)
        : world_(world), undo_(undo), lists_(lists), cut_short_(cut_short), arena_(arena), h_(h)
    {}

    // False: out of memory; the caller must then restore the poses of all bodies.
    [[nodiscard]] bool stop_at_impacts();

    // Have the geoms of all bodies been marked as moved?
    bool marked() const { return marked_; }
    // Was the body stopped?
    bool stopped(const Body& body) const;

  private:
    struct State {
        Motion motion;      // `until` is that of the group
        Real max_distance;  // upper bound of the distance that a point of its geoms has moved
        int group;          // the body that stands for it; of that one:
        Real until;         //   when it stops
        int carrier;        //   what carries it on from there; -1: nothing
        int met;            //   which of its bodies met that
        bool swung;         //   the carrier's turn would take it too far
        bool flagged, active;
    };
    struct Item {
        Geom* geom;
        Space* root;
        int body;
        Aabb way;
    };

    bool look_at_bodies();
    State state_of(std::size_t i) const;
    Real gate(const Body& body) const;
    bool choose_active();
    int find(int i);
    void join_groups();
    bool list_items();
    Aabb way_of(Geom& geom, const State* state) const;
    int index_of(const Geom& geom) const;
    Mover mover(Geom& geom, int body) const;
    bool stops(Geom& a, Geom& b) const;
    bool rule_for(const Mover& a, const Mover& b, const Body& body, const Body* other,
                  ImpactRule& rule) const;
    bool meet_while_held();
    bool meet_all();
    bool meet_others(const Item& item);
    bool may_meet_on_way(const Item& a, const Item& b) const;
    bool meet_each_other();
    void meet(const Item& a, Geom& other, int other_body);
    void stop(int body, Real time, int carrier);
    Vec3 stopped_place(std::size_t i) const;
    Carriage carriage_of(const State& group) const;
    Real longest_way_of_carrier(const State& group) const;
    void find_swung();
    Vec3 way_without_turn(const State& group) const;
    void place_bodies();

    World& world_;
    const StepUndo& undo_;
    ContinuousLists& lists_;
    CutShort& cut_short_;
    Arena& arena_;
    Real h_;
    std::span<State> states_;
    std::span<Item> items_;
    Real others_max_distance_ = 0;  // largest max_distance of the bodies that are not active
    bool marked_ = false;
};

}  // namespace epode
