// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What joint_contract.cpp needs of each type beyond its line in joint_types.inc: how one is made, by the name
// of its C function, and how its anchors and axes are set. A type that joint_geometry.cpp has no line for
// keeps what it takes over when it is attached, and is judged by all that does not need more.
#pragma once

#include <vector>

#include "../unit/joints/row_lines.h"
#include "ode/contact.h"
#include "ode/couplings.h"
#include "ode/objects.h"

namespace epode::test {

// Where a joint is set: at such a place all its equality errors vanish.
struct JointGeometry {
    Vec3 anchor, axis1, axis2;
    explicit JointGeometry(Dice& dice);
};

struct JointCase {
    int number;
    const char* name;
    dJointID (*create)(dWorldID world, const JointGeometry& g, bool swapped);
};

// Every line of joint_types.inc.
std::vector<JointCase> joint_cases();

inline constexpr const char* kNoGeometry =
    "joint_geometry.cpp has no line for this type, so nothing is known about its error where it is set";

bool has_geometry(dJointID joint);

// `swapped`: the joint is attached the other way round, and axes change places with their bodies. Nothing is
// set where the type has no line.
void set_geometry(dJointID joint, const JointGeometry& g, bool swapped = false);

}  // namespace epode::test
