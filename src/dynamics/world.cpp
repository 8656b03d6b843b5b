// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world that dies takes its bodies and its ungrouped joints along. Joints in a group stay in the group's
// care, without world and bodies, until the group is emptied: the order in which clients tear down does not
// matter.
#include "dynamics/world.h"

#include <atomic>

#include "base/call_guard.h"
#include "dynamics/forces/fluid.h"

namespace epode {
namespace {

std::atomic<int> g_busy{0};  // worlds

}  // namespace

void mark_busy(World& world, Busy busy)
{
    const int change = (busy != Busy::kNo) - (world.busy != Busy::kNo);
    if (change) g_busy.fetch_add(change, std::memory_order_relaxed);
    world.busy = busy;
}

bool any_world_busy() { return g_busy.load(std::memory_order_relaxed) > 0; }

bool still_busy(const World& world)
{
    CallGuard::release_left();
    return world.busy != Busy::kNo;
}

const char* busy_text(const World& world)
{
    if (world.busy == Busy::kCopy)
        return "Invalid operation while the world is saved, copied or restored, or its fluids are asked what "
               "lies in them";
    if (world.busy == Busy::kEnd) return "Invalid operation while the world is destroyed";
    return "Invalid operation during a step";
}

World::World() : Tagged(Tag::kWorld) {}

World::~World()
{
    while (bodies.count() > 0) destroy_body(bodies.newest());
    while (joints.count() > 0) {
        Joint& joint = joints.newest();
        if (joint.grouped) {
            detach(joint);
            unlink_from_world(joint);
        } else {
            destroy_joint(joint);
        }
    }
    while (!fluids.empty()) destroy_fluid(*fluids.back());
    if (step_state) free_step_state(step_state);
    StepMemory::let_go(memory);
    mark_busy(*this, Busy::kNo);
}

}  // namespace epode
