// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/joint_group.h"

namespace epode {

JointGroup::JointGroup() : Tagged(Tag::kJointGroup) {}

void empty_group(JointGroup& group)
{
    for (int i = group.joints.size(); i-- > 0;) destroy_joint(*group.joints[i]);
    group.joints.clear();
}

}  // namespace epode
