// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/world_events.h"

#include "dynamics/joint_drives.h"

namespace epode {
namespace {

// Impulse and place of a joint that has just broken.
dEvent break_of(const Joint& joint)
{
    dEvent event{};
    event.kind = dEventJointBreak, event.joint = to_handle(&joint);
    Vec3 direction = drives_of(joint).limits.linear;
    event.impulse = length(direction);
    if (normalize(direction)) store(event.normal, direction);
    if (joint.body1()) store(event.pos, joint.body1()->position());
    return event;
}

}  // namespace

void WorldEvents::begin_step(const World& world, const ContactWorld* contacts)
{
    list_.clear();
    if (list_.wants(dEventJointBreak)) list_breaks(world);
    if (contacts && list_.wants_contacts()) contacts->report(list_);
}

// The roster has the youngest joint first.
void WorldEvents::list_breaks(const World& world)
{
    if (world.driven_joints == 0) return;
    std::uint64_t order = ~0ull;
    for (const Joint& joint : world.joints) {
        --order;
        if (!joint.driven) continue;
        const BreakLimits& limits = drives_of(joint).limits;
        if (limits.broken && limits.step == world.step_count) list_.add({break_of(joint), order, 0});
    }
}

void WorldEvents::end_step(const World& world, Space* space, CutShort& cut_short)
{
    if (list_.wants_sensors() && !sensors_.update(world, space, cut_short, list_)) list_.lose();
    list_.sort();
}

void WorldEvents::restart(const World& world, Space* space)
{
    list_.clear();
    if (list_.wants_sensors() && !sensors_.restart(world, space)) list_.lose();
}

}  // namespace epode
