// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The common shapes of the C functions: each helper finds the joint, refuses bad numbers on behalf of its
// caller, and answers null when there is nothing to do. A joint without bodies is no mistake: setters of its
// geometry do nothing and readings are zero, in silence, as in ODE.
#pragma once

#include "joints/describe.h"
#include "joints/limit_motor.h"
#include "joints/parts.h"
#include "joints/registry.h"

namespace epode {

inline bool usable(Vec3 v) { return usable(v.x) && usable(v.y) && usable(v.z); }

// To read from an attached joint.
template <typename T>
T* attached_joint(dJointID id, const char* caller = __builtin_FUNCTION())
{
    T* joint = checked<T>(id, caller);
    return joint && joint->attached() ? joint : nullptr;
}

// To set a point or any other three numbers of an attached joint, and up to three more. Numbers are judged
// before the joint is seen to have no bodies.
template <typename T>
T* joint_for_point(dJointID id, Vec3 point, Vec3 more, const char* caller = __builtin_FUNCTION())
{
    T* joint = checked<T>(id, caller);
    return joint && demand(usable(point) && usable(more), caller, *joint) && joint->attached() ? joint
                                                                                               : nullptr;
}

template <typename T>
T* joint_for_point(dJointID id, Vec3 point, const char* caller = __builtin_FUNCTION())
{
    return joint_for_point<T>(id, point, Vec3{}, caller);
}

// To set a direction of an attached joint, and up to three more numbers; `axis` is normalised on the way,
// zero is refused.
template <typename T>
T* joint_for_axis(dJointID id, Vec3& axis, Vec3 more, const char* caller = __builtin_FUNCTION())
{
    T* joint = checked<T>(id, caller);
    const bool good = joint && demand(usable(axis) && usable(more) && normalize(axis), caller, *joint);
    return good && joint->attached() ? joint : nullptr;
}

template <typename T>
T* joint_for_axis(dJointID id, Vec3& axis, const char* caller = __builtin_FUNCTION())
{
    return joint_for_axis<T>(id, axis, Vec3{}, caller);
}

// To write a vector into the client's `result`.
template <typename T>
T* joint_for_result(dJointID id, const dReal* result, const char* caller = __builtin_FUNCTION())
{
    T* joint = checked<T>(id, caller);
    return joint && demand(result != nullptr, caller) && joint->attached() ? joint : nullptr;
}

// To hand over a number, attached or not.
template <typename T>
T* joint_for_number(dJointID id, Real value, const char* caller = __builtin_FUNCTION())
{
    T* joint = checked<T>(id, caller);
    return joint && demand(usable(value), caller, *joint) ? joint : nullptr;
}

// change() sets what read() answers. Another value than before wakes the joint's bodies in worlds that wake sleepers.
template <typename Read, typename Change>
void change_value(Joint& joint, Read&& read, Change&& change)
{
    const Real before = read();
    change();
    if (read() != before) wake_sleepers(joint);
}

// Unknown parameters are ignored in silence and read as zero.
template <typename T>
void set_joint_param(dJointID id, int param, Real value, const char* caller = __builtin_FUNCTION())
{
    T* joint = checked<T>(id, caller);
    if (!joint || !demand(usable_param(param, value), caller, *joint)) return;
    const auto read = [&] {
        Real now = 0;
        return joint->get_param(param, now) ? now : 0;
    };
    change_value(*joint, read, [&] { joint->set_param(param, value); });
}

template <typename T>
Real get_joint_param(dJointID id, int param, const char* caller = __builtin_FUNCTION())
{
    const T* joint = checked<T>(id, caller);
    Real value = 0;
    return joint && joint->get_param(param, value) ? value : 0;
}

}  // namespace epode
