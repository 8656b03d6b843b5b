// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world that dies takes its bodies and its ungrouped joints along. Joints in a group stay in the group's
// care, without world and bodies, until the group is emptied: the order in which clients tear down does not
// matter.
#include "dynamics/world.h"

#include <atomic>

#include "base/messages.h"

namespace epode {
namespace {

std::atomic<int> g_stepping{0};  // worlds

}  // namespace

void mark_stepping(World& world, bool on)
{
    if (world.stepping != on) g_stepping.fetch_add(on ? 1 : -1, std::memory_order_relaxed);
    world.stepping = on;
}

bool any_world_steps() { return g_stepping.load(std::memory_order_relaxed) > 0; }

World::World() : Tagged(Tag::kWorld) {}

World::~World()
{
    while (bodies.count() > 0) destroy_body(bodies.newest());
    while (joints.count() > 0) {
        Joint& joint = joints.newest();
        if (joint.grouped) {
            note(0, "warning: destroying world containing grouped joints");
            detach(joint);
            unlink_from_world(joint);
        } else {
            destroy_joint(joint);
        }
    }
    if (step_state) free_step_state(step_state);
    StepMemory::let_go(memory);
}

}  // namespace epode
