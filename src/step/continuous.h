// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Continuous collision: after a step has put all bodies where their velocities lead, those that carry a geom
// with dContinuousOn and have moved by more than a small share of its thickness are looked at along their
// whole way. Who would go too deep into something (query/impact.h) stands still from the time at which it
// meets it; velocities stay, and the next collision finds the contact.
//   groups    what joints other than contacts hold together stops together, or the joints would open
//   carried   what meets a moving body that is not stopped, be it slow or kinematic, is carried on by it
//             for the rest of the step, or it would be run over
//   each other  of two that are looked at both stop. Who meets a body that has been stopped for another
//             reason is tried again: up to kRounds times, in the order of the islands
// All on the caller's thread, so that the threads of the step are no matter. Nothing is looked at while no
// geom anywhere has dContinuousOn. Rejected: to let the rest of the step be made again from the moment of
// impact, as if it were a step of its own: contacts belong to the program.
#pragma once

#include "base/array.h"
#include "collide/geom.h"
#include "dynamics/island.h"
#include "query/impact.h"
#include "step/undo.h"

namespace epode {

// Lists that stay from step to step.
struct ContinuousLists {
    Array<Geom*> near;
    struct Pair {
        int first, second;  // geoms of active bodies
    };
    Array<Pair> pairs;
};

class Continuous {
  public:
    Continuous(World& world, const StepUndo& undo, ContinuousLists& lists, Arena& arena, Real h)
        : world_(world), undo_(undo), lists_(lists), arena_(arena), h_(h)
    {}

    // False: out of memory; some bodies are then where they must be taken back from.
    [[nodiscard]] bool stop_at_impacts();

    // Have the geoms of all bodies been marked as moved?
    bool marked() const { return marked_; }
    // Was the body stopped?
    bool stopped(const Body& body) const;

  private:
    struct State {
        Motion motion;      // `until` is that of the group
        Real max_distance;  // how far a point of its geoms has moved at most
        int group;          // the body that stands for it; of that one:
        Real until;         //   when it stops
        int carrier;        //   what carries it on from there; -1: nothing
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
    bool stops(const Geom& a, const Geom& b) const;
    bool rule_for(const Mover& a, const Mover& b, const Body& body, const Body* other,
                  ImpactRule& rule) const;
    bool meet_all();
    bool meet_others(const Item& item);
    bool meet_each_other();
    void meet(const Item& a, Geom& other, int other_body);
    void stop(int body, Real time, int carrier);
    void place_bodies();

    World& world_;
    const StepUndo& undo_;
    ContinuousLists& lists_;
    Arena& arena_;
    Real h_;
    std::span<State> states_;
    std::span<Item> items_;
    Real others_max_distance_ = 0;  // State::max_distance of all that are not active
    bool marked_ = false;
};

}  // namespace epode
