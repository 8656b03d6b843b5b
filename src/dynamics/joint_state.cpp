// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/joint_state.h"

namespace epode {
namespace {

constexpr unsigned kRows = 7, kDisabled = 8, kActive = 16;
static_assert(kMaxJointRows <= int(kRows));

}  // namespace

std::uint8_t state_bits(const Joint& joint)
{
    return std::uint8_t(joint.impulse_rows | (joint.disabled ? kDisabled : 0u) |
                        (joint.world->joints.is_active(joint) ? kActive : 0u));
}

void state(Joint& joint, std::uint8_t bits, StateStream& stream)
{
    const int rows = int(bits & kRows);
    const int most = is_contact(joint) ? 0 : joint.type->max_rows;
    if (!stream.demand(rows <= most, "a joint of the state has more impulses than rows")) return;
    if (stream.stores()) {
        joint.impulse_rows = std::uint8_t(rows);
        joint.disabled = bits & kDisabled;
        auto& joints = joint.world->joints;
        bits& kActive ? joints.activate(joint) : joints.deactivate(joint);
    }
    if (rows > 0) stream.guesses(impulses(joint), rows);
    if (joint.type->state) joint.type->state(joint, stream);
}

}  // namespace epode
