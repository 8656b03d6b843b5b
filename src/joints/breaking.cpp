// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "joints/breaking.h"

#include "dynamics/world.h"
#include "rows/wrench.h"

namespace epode {

void add_load(Joint& joint, const RowBlock& block, const RowSystem& system)
{
    BreakLimits& limits = drives_of(joint).limits;
    if (!limits.any()) return;
    for (int i = block.first; block.term_count > 0 && i < block.first + block.count; ++i)
        limits.linear.x += system.numbers[std::size_t(i)].p;  // the force along the coupling
    const BlockWrench load = wrench_of(system, block, 1);
    limits.linear += load.f1, limits.angular += load.couple;
}

void break_joints(World& world, Real h)
{
    if (world.driven_joints == 0) return;
    world.joints.for_each_active([&](Joint& joint) {
        if (!joint.driven || joint.disabled) return;
        BreakLimits& limits = drives_of(joint).limits;
        if (!limits.any()) return;
        const bool held =
            !(length(limits.linear) > limits.force * h) && !(length(limits.angular) > limits.torque * h);
        if (held) return forget_load(joint);
        limits.broken = true, limits.step = world.step_count;
        joint.disabled = true;
        forget_impulses(joint);
    });
}

void forget_loads(World& world)
{
    if (world.driven_joints == 0) return;
    world.joints.for_each_active([](Joint& joint) {
        if (joint.driven) forget_load(joint);
    });
}

}  // namespace epode
