// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/joint_group.h"

#include "base/prefetch.h"

namespace epode {

JointGroup::JointGroup() : Tagged(Tag::kJointGroup) {}

void empty_group(JointGroup& group)
{
    constexpr int kAhead = 16, kLines = 2;
    for (int i = group.joints.size(); i-- > 0;) {
        if (i >= kAhead) prefetch<kLines>(group.joints[i - kAhead]);
        destroy_joint(*group.joints[i]);
    }
    group.joints.clear();
}

}  // namespace epode
