// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints that live and die together, usually a frame's contacts. The slots of the joints come from the
// pools of their types, so emptying and refilling a group allocates nothing once it has been large.
#pragma once

#include "base/array.h"
#include "dynamics/joint.h"

namespace epode {

struct JointGroup : Tagged {
    JointGroup();
    Array<Joint*> joints;  // in order of creation
};

template <>
struct HandleOf<JointGroup> {
    using Id = dJointGroupID;
    static constexpr Tag kTag = Tag::kJointGroup;
};

void empty_group(JointGroup& group);  // destroys the joints, the newest first

}  // namespace epode
