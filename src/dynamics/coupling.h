// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A joint between joints: s = sum a_i q_i over axes of its members. It is in no body's list; the world lists
// its couplings, and a member only knows that it is one (Joint::coupled).
#pragma once

#include "dynamics/joint.h"
#include "rows/row_writer.h"

namespace epode {

inline constexpr int kMaxCoupledAxes = kMaxBodyTerms / 2;

struct CoupledAxis {
    Joint* joint = nullptr;  // null: the place is empty
    int axis = 0;
    Real factor = 0;
};

struct CouplingJoint : LastingJoint {
    using LastingJoint::LastingJoint;
    CoupledAxis member[kMaxCoupledAxes];
    bool moves = false;  // its factors have changed since it has its axes: they are state, no structure
    Real force = 0;      // along s, the mean over the last step
};

inline bool is_coupling(const Joint& joint) { return joint.type->number == dJointTypeCoupling; }
inline CouplingJoint& coupling_of(Joint& joint) { return static_cast<CouplingJoint&>(joint); }
inline const CouplingJoint& coupling_of(const Joint& joint)
{
    return static_cast<const CouplingJoint&>(joint);
}

// f(member) for each place that is not empty.
template <typename F>
void for_each_member(const CouplingJoint& coupling, F&& f)
{
    for (const CoupledAxis& member : coupling.member)
        if (member.joint) f(member);
}

// f(body) for the bodies of all members; some may come several times.
template <typename F>
void for_each_body(const CouplingJoint& coupling, F&& f)
{
    for_each_member(coupling, [&](const CoupledAxis& member) {
        for (const JointNode& node : member.joint->node)
            if (node.body) f(*node.body);
    });
}

// It and all members are enabled and attached, and some body can move.
bool acts(const CouplingJoint& coupling);

// Into the world's list, if it is not in it. False: out of memory.
[[nodiscard]] bool list_coupling(CouplingJoint& coupling);

// A coupling or a member leaves the world. Couplings of a member are disabled.
void leave_couplings(Joint& joint);

// Makes those active that have an active body.
void activate_couplings(World& world);

}  // namespace epode
