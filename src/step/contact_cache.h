// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's contacts are new joints in every step; this cache finds last step's impulses for them. A contact is
// known by its two bodies and its place in the first one's frame: among the old contacts of the pair, the
// nearest within kReach of the lever arm and with a similar normal is taken, each at most once. The friction
// impulse is kept as a world vector and projected on the new tangents. Bodies, not geoms, are the key: clients
// need not fill dContactGeom::g1 and g2.
#pragma once

#include "base/array.h"
#include "dynamics/joint.h"
#include "rows/row_system.h"

namespace epode {

class ContactCache {
  public:
    // Writes `share` of the remembered impulses into the numbers of a contact block.
    void load(const Joint& joint, const RowBlock& block, RowSystem& system, Real share);

    // Begins remembering a new step with at most `contacts` contacts; false: out of memory, cache empty.
    bool begin(int contacts);
    void remember(const Joint& joint, const RowBlock& block, const RowSystem& system);
    // What was remembered becomes what is loaded from.
    void end();
    void clear();

  private:
    struct Entry {
        std::uint64_t serial1, serial2;
        Vec3 place;     // lever arm from body 1, in its frame
        Vec3 normal;    // world
        Vec3 friction;  // world impulse
        Real push;      // normal impulse
        int next;       // entry in the same bucket, -1 at the end
        bool used;
    };
    static std::size_t hash(std::uint64_t a, std::uint64_t b);

    Array<Entry> entries_, fresh_;
    Array<int> buckets_;  // power of two many, index of the first entry or -1
};

}  // namespace epode
