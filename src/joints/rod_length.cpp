// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "joints/rod_length.h"

#include "joints/registry.h"

namespace epode {

Real rod_length(const Joint& joint)
{
    const dJointID id = to_handle(&joint);
    if (joint.type->number == dJointTypeDBall) return dJointGetDBallDistance(id);
    return joint.type->number == dJointTypeDHinge ? dJointGetDHingeDistance(id) : 0;
}

}  // namespace epode
