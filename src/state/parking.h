// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Objects that are destroyed for the program, and may come back under the same handle. A parked object is out
// of all lists of the living, and its tag makes its handle stale; all else in it stays as it was. Its place in
// its pool stays taken, so that no other object gets the handle.
#pragma once

#include "base/array.h"
#include "dynamics/joint_group.h"
#include "state/topology.h"

namespace epode {

class Parking {
  public:
    Parking() = default;
    Parking(const Parking&) = delete;
    Parking& operator=(const Parking&) = delete;
    ~Parking() { destroy_before(~std::uint64_t(0)); }

    [[nodiscard]] bool reserve(int more) { return parked_.reserve(parked_.size() + more); }
    // The object has left all lists. `last`: the last frame that may have it. Memory has been reserved.
    void put(Body& body, std::uint64_t last) { put({Kind::kBody, &body, nullptr, last}, body); }
    void put(Joint& joint, dJointGroupID group, std::uint64_t last)
    {
        put({Kind::kJoint, &joint, group, last}, joint);
    }
    void put(Geom& geom, std::uint64_t last) { put({Kind::kGeom, &geom, nullptr, last}, geom); }

    // Alive again, and to be entered into its lists.
    template <typename O>
    void take(O& object)
    {
        const int i = object.tag == kParked ? find(&object) : -1;
        if (i < 0) return;
        object.tag = HandleOf<O>::kTag;
        if constexpr (std::is_same_v<O, Joint>)
            if (parked_[i].group) (void)returned_.push({&object, parked_[i].group});
        parked_.remove_swap(i);
    }
    bool has(const void* object) const { return find(object) >= 0; }
    // Memory for groups of joints that may come back. False: out of memory.
    [[nodiscard]] bool reserve_groups();
    // Joints that have been taken enter the groups that they were in, if these still exist.
    void enter_groups();

    // Those whose last frame is before this one.
    void destroy_before(std::uint64_t frame);
    // No frame after this one is left.
    void forget_after(std::uint64_t frame);

  private:
    enum class Kind { kBody, kJoint, kGeom };
    struct Entry {
        Kind kind;
        Tagged* object;
        dJointGroupID group;  // of a joint; null: none
        std::uint64_t last;
    };
    void put(const Entry& entry, Tagged& object)
    {
        object.tag = kParked;
        (void)parked_.push(entry);
    }
    struct Returned {
        Joint* joint;
        dJointGroupID group;
    };
    int find(const void* object) const;
    static void destroy(const Entry& entry);

    Array<Entry> parked_;
    Array<Returned> returned_;
};

}  // namespace epode
