// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How a file of this folder becomes a joint type: the list joint_types.inc is expanded into one JointType per
// struct, JOINT_DEFINE fills it from the struct's members, and create_joint/checked are what the C functions
// stand on. A list and not self-registration: no order of static initialisation, and no linker may drop a
// type from an archive.
#pragma once

#include "base/objects/pool.h"
#include "base/refusals.h"
#include "base/streams/state_stream.h"
#include "base/streams/structure_stream.h"
#include "dynamics/joint.h"
#include "dynamics/joint_group.h"
#include "dynamics/world.h"
#include "rows/row_writer.h"

namespace epode {

template <typename T>
struct JointTypeOf;

#define JOINT_TYPE(Name, Number)                                            \
    struct Name;                                                            \
    extern const JointType k##Name##Type;                                   \
    template <>                                                             \
    struct JointTypeOf<Name> {                                              \
        static const JointType& get() { return k##Name##Type; }             \
        static constexpr int kNumber = Number;                              \
        static constexpr const char* kRefusal = "joint type is not " #Name; \
    };
#include "joints/joint_types.inc"
#undef JOINT_TYPE

// The type with this number of the interface, or null.
const JointType* joint_type(int number);

// Says in words what a struct lacks to be a joint type. Optional members: bodies_changed(), set_param(int,
// Real), get_param(int, Real&), Axle axle(int node), state(StateStream&) of what it keeps from step to step and of its settings
// that are numbers of motors and softness, kNeedsTwoBodies, shift(Vec3) of what it keeps in the world's
// frame, axes() and axis_at(int), which give the type
// coordinates and drives, AxisMotor motor_at(int), which must come with them, LimitMotor* stops_of(int axis)
// and OwnSoftness* own_softness(), which may be springs in physical units, and, where not all objects of the
// type are of one pool, destroy() and static Joint* make(World&, StructureStream&).
template <typename T>
consteval bool is_joint_type()
{
    static_assert(std::is_base_of_v<LastingJoint, T> || JointTypeOf<T>::kNumber == dJointTypeContact,
                  "a joint type derives from LastingJoint, which keeps impulses; contacts alone do without");
    static_assert(
        requires { int{T::kMaxRows}; }, "a joint type states kMaxRows, the most rows it ever writes");
    static_assert(T::kMaxRows <= kMaxJointRows, "a joint type writes at most kMaxJointRows rows");
    static_assert(
        requires(T & t, RowWriter & out) { t.emit(out); },
        "a joint type writes its rows in void emit(RowWriter&)");
    static_assert(
        requires(const T& t, DifWriter& out) {
            T::kDifName[0];
            t.describe(out);
        },
        "a joint type tells what it is made of: kDifName and void describe(DifWriter&) const");
    static_assert(
        requires(T & t, StructureStream & stream) { t.structure(stream); },
        "a joint type visits its anchors, axes and modes: void structure(StructureStream&)");
    static_assert(
        !requires(T & t, Real v) { t.set_param(0, v); } ||
            requires(const T& t, Real& v) { t.get_param(0, v); },
        "a joint type that lets a parameter be set lets it be read: bool get_param(int, Real&) const");
    static_assert(
        !requires(const T& t) { t.axes(); } || requires(const T& t) { JointAxis{t.axis_at(0)}; },
        "a joint type that has axes tells what they are: JointAxis axis_at(int) const");
    static_assert(
        !requires(const T& t) { t.axes(); } || requires(T & t) { t.motor_at(0); },
        "a joint type that has axes tells what moves them: AxisMotor motor_at(int)");
    return true;
}
template <typename T>
concept JointLike = is_joint_type<T>();

template <JointLike T>
constexpr JointType describe_joint(const char* name)
{
    JointType type{};
    type.number = JointTypeOf<T>::kNumber;
    type.name = name;
    type.max_rows = T::kMaxRows;
    type.size = sizeof(T);
    type.needs_two_bodies = requires { T::kNeedsTwoBodies; };
    type.emit = [](Joint& j, RowWriter& out) { static_cast<T&>(j).emit(out); };
    type.attached = [](Joint& j) {
        if constexpr (requires(T & t) { t.bodies_changed(); }) static_cast<T&>(j).bodies_changed();
        if (j.type->forget_turns) j.type->forget_turns(j);
    };
    type.set_param = [](Joint& j, int param, Real value) {
        if constexpr (requires(T & t) { t.set_param(param, value); })
            return static_cast<T&>(j).set_param(param, value);
        else
            return (void)j, (void)param, (void)value, false;
    };
    type.get_param = [](const Joint& j, int param, Real& value) {
        if constexpr (requires(const T& t) { t.get_param(param, value); })
            return static_cast<const T&>(j).get_param(param, value);
        else
            return (void)j, (void)param, (void)value, false;
    };
    if constexpr (requires(const T& t) { t.axes(); }) {
        type.axes = [](const Joint& j) { return static_cast<const T&>(j).axes(); };
        type.axis = [](const Joint& j, int i) { return static_cast<const T&>(j).axis_at(i); };
        type.continuous = [](const Joint& j, int i) {
            return const_cast<T&>(static_cast<const T&>(j)).motor_at(i).motor.turns.continuous;
        };
        type.count_turns = [](Joint& j, int i, bool continuous, Real position) {
            const auto [motor, sense] = static_cast<T&>(j).motor_at(i);
            motor.turns.continuous = continuous;
            motor.turns.take(sense * position);
        };
        type.stop_force = [](Joint& j, int i) -> Real {
            const auto [motor, sense] = static_cast<T&>(j).motor_at(i);
            return sense * motor.stop_force(lasting(j));
        };
        type.forget_turns = [](Joint& j) {
            T& joint = static_cast<T&>(j);
            for (int i = 0; i < joint.axes(); ++i) joint.motor_at(i).motor.turns.follows = false;
        };
    }
    if constexpr (requires(const T& t) { t.axle(0); })
        type.axle = [](const Joint& j, int node) { return static_cast<const T&>(j).axle(node); };
    if constexpr (requires(T & t) { t.stops_of(0); })
        type.stops = [](Joint& j, int i) -> LimitMotor* { return static_cast<T&>(j).stops_of(i); };
    if constexpr (requires(T & t) { t.own_softness(); })
        type.softness = [](Joint& j) -> OwnSoftness* { return static_cast<T&>(j).own_softness(); };
    type.dif_name = T::kDifName;
    type.describe = [](const Joint& j, DifWriter& out) { static_cast<const T&>(j).describe(out); };
    if constexpr (requires(T & t, StateStream & stream) { t.state(stream); })
        type.state = [](Joint& j, StateStream& stream) { static_cast<T&>(j).state(stream); };
    if constexpr (requires(T & t) { t.shift(Vec3{}); })
        type.shift = [](Joint& j, Vec3 by) { static_cast<T&>(j).shift(by); };
    type.structure = [](Joint& j, StructureStream& stream) { static_cast<T&>(j).structure(stream); };
    type.make = [](World& world, StructureStream& stream) -> Joint* {
        if constexpr (requires { T::make(world, stream); }) {
            return T::make(world, stream);
        } else {
            T* joint = Pool<T>::create(JointTypeOf<T>::get(), world);
            if (joint) joint->structure(stream);
            return joint;
        }
    };
    type.destroy = [](Joint& j) {
        if constexpr (requires(T & t) { t.destroy(); })
            static_cast<T&>(j).destroy();
        else
            Pool<T>::destroy(static_cast<T*>(&j));
    };
    return type;
}

#define JOINT_DEFINE(Name) constinit const JointType k##Name##Type = describe_joint<Name>(#Name)

// False after a refusal.
inline bool demand(bool condition, const char* caller)
{
    if (!kChecked || condition) return true;
    refuse_for(caller, "Bad argument(s)");
    return false;
}

// Of an argument for this joint: the diagnosis of its world names both.
inline bool demand(bool condition, const char* caller, const Joint& joint)
{
    if (!condition) concern({0, joint.world, nullptr, to_handle(&joint)});
    return demand(condition, caller);
}

// The new joint, or null: bad handles, or memory is exhausted.
template <JointLike T, typename... Arguments>
dJointID create_joint_for(const char* caller, dWorldID w, dJointGroupID g, const Arguments&... arguments)
{
    World* world = from_handle<World>(w);
    JointGroup* group = from_handle<JointGroup>(g);
    if (!demand(world && (group || !g), caller)) return nullptr;
    T* joint = Pool<T>::create(JointTypeOf<T>::get(), *world, arguments...);
    if (joint && link_into_world(*joint, group)) return to_handle<Joint>(joint);
    if (joint) Pool<T>::destroy(joint);
    refuse_for(caller, kOutOfMemory);
    return nullptr;
}

template <JointLike T>
dJointID create_joint(dWorldID w, dJointGroupID g, const char* caller = __builtin_FUNCTION())
{
    return create_joint_for<T>(caller, w, g);
}

// The joint behind a handle, or null after a refusal in ODE's words on behalf of the C function `caller`.
template <typename T>
T* checked(dJointID id, const char* caller = __builtin_FUNCTION())
{
    Joint* joint = from_handle<Joint>(id);
    if (!kChecked || (joint && joint->type == &JointTypeOf<T>::get())) return static_cast<T*>(joint);
    refuse_for(caller, joint ? JointTypeOf<T>::kRefusal : "Bad argument(s)");
    return nullptr;
}

}  // namespace epode
