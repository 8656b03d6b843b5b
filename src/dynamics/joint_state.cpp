// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/joint_state.h"

#include <cmath>

#include "dynamics/joint_drives.h"

namespace epode {
namespace {

constexpr unsigned kRows = 15, kJointDisabled = 16, kJointActive = 32, kJointBegun = 64;
static_assert(kMaxBlockRows <= int(kRows));
constexpr int kWithMeans = 6;  // the format from which on joints have mean forces

constexpr std::uint32_t kAxisDriven = 1;          // of an axis
constexpr std::uint32_t kContinuous = 2;          // of states of format 5 or less, with the position
constexpr std::uint32_t kBroken = 1;              // of the limits
constexpr std::uint32_t kLimits = 1 << kMaxAxes;  // of the drives: bits of axes, and this one

int max_rows(const Joint& joint)
{
    if (is_contact(joint)) return 0;
    return joint.type->max_rows + (joint.driven ? kMaxDriveRows : 0);
}

void state(Joint& joint, int number, StateStream& stream)
{
    AxisDrive& axis = drives_of(joint).axis[number];
    dDrive& d = axis.drive;
    Real position = 0;
    const std::uint32_t bits = stream.unusual({{&d.stiffness, 0, false, 0},
                                               {&d.damping, 0, false, 0},
                                               {&d.armature, 0, false, 0},
                                               {&d.friction, 0, false, 0},
                                               {&d.target, 0},
                                               {&d.target_velocity, 0},
                                               {&d.force, 0},
                                               {&d.force_limit, 0, true, 0},
                                               {&position, 0},
                                               StateStream::computed(axis.force, 0)},
                                              axis.driven ? kAxisDriven : 0);
    if (!stream.stores()) return;
    axis.driven = bits & kAxisDriven;
    if (bits & kContinuous && joint.type->count_turns) joint.type->count_turns(joint, number, true, position);
}

void state(BreakLimits& limits, StateStream& stream)
{
    const std::uint32_t bits = stream.unusual(
        {{&limits.force, kInf, true, 0}, {&limits.torque, kInf, true, 0}}, limits.broken ? kBroken : 0);
    const std::uint64_t step = stream.long_word(limits.step);
    if (!stream.stores()) return;
    limits.broken = bits & kBroken, limits.step = step;
    limits.linear = limits.angular = {};
}

bool is_used(const AxisDrive& axis)
{
    if (axis.driven) return true;
    const dDrive& d = axis.drive;
    for (const Real x : {d.stiffness, d.damping, d.armature, d.friction, d.target, d.target_velocity, d.force,
                         d.force_limit, axis.force})
        if (x != 0 || std::signbit(x)) return true;
    return false;
}

bool is_used(const BreakLimits& limits) { return limits.any() || limits.broken || limits.step != 0; }

// Only what is used takes space: few joints have all of it.
void state_of_drives(Joint& joint, StateStream& stream)
{
    JointDrives& drives = drives_of(joint);
    std::uint32_t used = is_used(drives.limits) ? kLimits : 0;
    for (int i = 0; i < kMaxAxes; ++i) used |= std::uint32_t(is_used(drives.axis[i])) << i;
    const std::uint32_t bits = stream.word(used);
    for (int i = 0; i < kMaxAxes; ++i)
        if (bits >> i & 1)
            state(joint, i, stream);
        else if (stream.stores() && used >> i & 1)
            drives.axis[i] = {};
    if (bits & kLimits)
        state(drives.limits, stream);
    else if (stream.stores() && used & kLimits)
        drives.limits = {};
}

}  // namespace

namespace {

// Earlier formats know the impulses only.
void memory(LastingJoint& joint, int rows, StateStream& stream)
{
    stream.guesses(joint.impulse, rows);
    if (stream.format() < kWithMeans) {
        if (stream.stores()) joint.mean_rows = 0, joint.mean_time = joint.impulse_step = 0;
        return;
    }
    const std::uint32_t mean_rows =
        stream.index(joint.mean_rows, kMaxBlockRows + 1, "a joint with too many rows");
    if (stream.stores()) joint.mean_rows = std::uint8_t(mean_rows);
    stream.guesses(joint.mean, int(mean_rows));
    stream.reals(&joint.impulse_step, 1), stream.reals(&joint.mean_time, 1);
}

}  // namespace

std::uint8_t state_bits(const Joint& joint)
{
    return std::uint8_t(joint.impulse_rows | (joint.disabled ? kJointDisabled : 0u) |
                        (joint.world->joints.is_active(joint) ? kJointActive : 0u) |
                        (joint.begun ? kJointBegun : 0u));
}

void state(Joint& joint, std::uint8_t bits, StateStream& stream)
{
    const int rows = int(bits & kRows);
    if (!stream.demand(rows <= max_rows(joint), "a joint of the state has more impulses than rows")) return;
    if (stream.stores()) {
        joint.impulse_rows = std::uint8_t(rows);
        joint.disabled = bits & kJointDisabled;
        joint.begun = stream.format() < kWithMeans ? rows > 0 : (bits & kJointBegun) != 0;
        auto& joints = joint.world->joints;
        bits& kJointActive ? joints.activate(joint) : joints.deactivate(joint);
    }
    if (rows > 0) memory(lasting(joint), rows, stream);
    if (joint.type->state) joint.type->state(joint, stream);
    if (joint.driven) state_of_drives(joint, stream);
}

}  // namespace epode
