// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The table of joint types by number.
#include "joints/registry.h"

namespace epode {

const JointType* joint_type(int number)
{
    static constexpr const JointType* kTypes[] = {
#define JOINT_TYPE(Name, Number) &k##Name##Type,
#include "joints/joint_types.inc"
#undef JOINT_TYPE
    };
    for (const JointType* type : kTypes)
        if (type->number == number) return type;
    return nullptr;
}

}  // namespace epode
