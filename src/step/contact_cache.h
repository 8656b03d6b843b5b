// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's contacts are new joints in every step; this cache finds last step's impulses for them. A contact is
// known by its two bodies and its place in the first one's frame: among the old contacts of the pair, the
// nearest within kReach of the lever arm and with a similar normal is taken, each at most once. The friction
// impulse is kept as a world vector and projected on the new tangents. Bodies, not geoms, are the key:
// clients need not fill dContactGeom::g1 and g2.
#pragma once

#include "base/array.h"
#include "dynamics/joint.h"
#include "rows/row_system.h"

namespace epode {

class ContactCache {
  public:
    // A step begins whose contacts have tickets 0 ... tickets - 1, not all of which need be used. False: out
    // of memory. What the step may need is reserved now: end() cannot fail.
    [[nodiscard]] bool begin(int tickets);
    // Notes a contact block under its ticket and writes `share` of what is remembered of it into its numbers.
    // This and `remember` may run at the same time for contacts of different bodies.
    void load(int ticket, const Joint& joint, const RowBlock& block, RowSystem& system, Real share);
    // The answer for a ticket that has been loaded.
    void remember(int ticket, const RowBlock& block, const RowSystem& system);
    // The step is over: what it noted is what the next one loads from.
    void end();
    // There was no step: the next one finds what this one has found.
    void take_back();

  private:
    // Seven digits are plenty for a start value, and an entry is then one cache line.
    struct Float3 {
        float x, y, z;
    };
    struct Entry {
        std::uint64_t serial1, serial2;  // of the bodies; serial1 = 0: a ticket that was not used
        Float3 place;                    // lever arm from body 1, in its frame
        Float3 normal;                   // world
        Float3 friction;                 // world impulse
        float push;                      // normal impulse
        int next;                        // entry in the same bucket, -1 at the end
        bool used;
    };
    static_assert(sizeof(Entry) == 64);
    static Float3 narrow(Vec3 a) { return {float(a.x), float(a.y), float(a.z)}; }
    static Vec3 widen(Float3 a) { return {a.x, a.y, a.z}; }
    static std::size_t hash(std::uint64_t a, std::uint64_t b);
    Entry* find(const Entry& like);
    void drop_unused();
    static int buckets_for(int entries);

    Array<Entry> entries_, fresh_;
    Array<int> buckets_;  // power of two many, index of the first entry or -1
};

}  // namespace epode
