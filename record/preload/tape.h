// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The calls that concern one world, with numbers for handles, as record/file/calls.h wants them. Numbers of
// handles that died stay in the maps until the address comes back: a call on a dead thing, which the library
// refuses, is kept as that.
#pragma once

#include <map>

#include "record/file/calls.h"
#include "record/preload/observer.h"

namespace epode::record {

class WorldTape {
  public:
    void body_made(dBodyID body);
    void joint_made(const char* name, dJointID joint, dJointGroupID group);
    void contact_made(dJointID joint, dJointGroupID group, const dContact& contact);
    void body_gone(dBodyID body) { gone("dBodyDestroy", bodies_, body, ArgumentKind::kBody); }
    void joint_gone(dJointID joint) { gone("dJointDestroy", joints_, joint, ArgumentKind::kJoint); }
    // A group that no joint of this world was ever in says nothing.
    void group_emptied(dJointGroupID group);
    void called(const char* name, const Given* given, int count);
    // Steps of this size; substeps for those that have them, else -1.
    void stepped(const char* name, double dt, int substeps);
    void stepped_many(double dt, int stepper, int iterations, int steps);

    bool knows(dJointID joint) const { return joints_.contains(joint); }
    bool empty() const { return tape_.empty(); }
    CallBlock take() { return tape_.take(); }

  private:
    template <class Id>
    void gone(const char* name, const std::map<Id, std::int32_t>& numbers, Id id, ArgumentKind kind)
    {
        const auto found = numbers.find(id);
        if (found != numbers.end()) tape_.add(name, {Argument::of(kind, found->second)});
    }
    Argument group(dJointGroupID group);
    Argument argument(const Given& given);

    CallTape tape_;
    std::map<dBodyID, std::int32_t> bodies_;
    std::map<dJointID, std::int32_t> joints_;
    std::map<dJointGroupID, std::int32_t> groups_;
    std::int32_t body_count_ = 0, joint_count_ = 0;
};

}  // namespace epode::record
