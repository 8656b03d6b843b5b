// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contacts that a world manages. Every step makes a new list of pairs from the one before: pairs of the
// space in its order, each with its patches brought up to date; then the new list takes the place of the
// old. A step that cannot be finished just drops the new one, so it leaves no trace. Patches move from list
// to list, which costs less than looking for them in holes, and neighbours in space stay neighbours in
// memory.
#pragma once

#include <atomic>

#include "base/arena.h"
#include "base/array.h"
#include "bvh/near_leaves.h"
#include "collide/space.h"
#include "contacts/contact_pair.h"
#include "contacts/narrow_phase.h"
#include "contacts/pair_finder.h"
#include "dynamics/island.h"
#include "ode/contacts.h"
#include "tasks/tasks.h"

namespace epode {

class ContactWorld {
  public:
    dSpaceID space = nullptr;
    dContactFilter* filter = nullptr;
    void* filter_data = nullptr;

    // Would update() find what it found in the last step, given that all bodies sleep? Nobody was awake then,
    // and nothing has happened to the space since.
    bool is_settled(const Space& in) const;
    // The step is done, without an update: all pairs are as they were.
    void accept_settled(Real h);

    // Null: there is none, or it has been destroyed.
    Space* live_space() const { return space ? space_from(space) : nullptr; }

    // Pairs and patches at the bodies' present poses. False: out of memory.
    // `h`: the coming step.
    [[nodiscard]] bool update(const World& world, Space& in, Real h, const Tasks& tasks);
    // The touching patches of what `update` found, in order.
    [[nodiscard]] bool touching(const Tasks& tasks, Arena& arena, std::span<PatchEdge>& out);
    // The step is done: what it found is what the next one starts from. `h`: its length.
    void accept(Real h, const Tasks& tasks);
    void forget();

    int events(dContactEvent* out, int room) const;
    int contacts(dWorldContact* out, int room) const;

  private:
    // Pairs and what came of them.
    struct List {
        Array<ContactPair> pairs;
        Array<KeptPatch> patches;  // those of a pair lie together; there are gaps
        Array<NearLeaves> leaves;
        std::uint64_t ties = 0;  // of the world, when `tied` was right

        std::span<const KeptPatch> of(const ContactPair& pair) const
        {
            return patches.span().subspan(std::size_t(pair.first), pair.count);
        }
        std::span<const KeptPatch> of(int pair) const
        {
            return pair < 0 ? std::span<const KeptPatch>{} : of(pairs.data()[pair]);
        }
    };

    // What a range of found pairs has; after summing up, where it begins.
    struct PairRange {
        int pairs = 0, patches = 0, leaves = 0;
    };

    [[nodiscard]] bool choose_pairs(const World& world, const Tasks& tasks);
    [[nodiscard]] bool choose_range(const World& world, int range, RecordFinder& finder);
    [[nodiscard]] bool list_pairs(const World& world, const Tasks& tasks);
    void ask_filter();
    void collide_pairs(const World& world, Real h, const Tasks& tasks);
    void update_one(ContactPair& pair, int place, const NarrowSettings& settings);
    NearLeaves* leaves_of(const ContactPair& pair);

    List last_, fresh_;  // of the last step, of this one
    Array<GeomPair> found_;
    Array<PairRange> ranges_;
    Array<int> table_;
    Array<dContactEvent> ended_;  // of the last step
    Real h_ = 0;
    std::atomic<bool> all_asleep_{false};  // no pair that the last update has found has an awake body
    bool settled_ = false;                 // so it was in the last step that was made
    std::uint64_t edition_ = 0;            // of the space, then
};

}  // namespace epode
