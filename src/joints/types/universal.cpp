// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Universal (Cardan) joint: a common point, and an axis a1 fixed in body 1 perpendicular to a2 fixed in
// body 2.
//   C(x) = x2 + R2 s2 - x1 - R1 s1 = 0       three rows of a ball
//          -a1.a2 = 0                       and angles: see cross.h
//   stops and motors along a1 and a2.
// Attached as (0, B), the client's axis 1 is the internal axis 2 (the world's), angle1 = internal angle2,
// angle2 = -internal angle1; stops and motors keep internal numbers.
#include "joints/access.h"
#include "joints/types/cross.h"

namespace epode {

struct Universal : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "universal_joint";
    Universal(const JointType& t, World& w) : LastingJoint(t, w), motor{LimitMotor(w), LimitMotor(w)} {}

    AnchorPair anchor;
    Cross arms{{{1, 0, 0}, {0, 1, 0}}, {}};
    LimitMotor motor[2];

    Vec3 user_axis(int i) const { return arms.axis(*this, node_of(*this, i)); }
    Axle axle(int i) const { return {arms.local[i], anchor.local[i]}; }
    Real user_angle(int i) const
    {
        const Real angle = arms.angle(*this, node_of(*this, i));
        return reverse && i == 1 ? -angle : angle;
    }
    Real user_rate(int i) const { return arms.rate(*this, node_of(*this, i)); }
    void set_zero(Real reading1 = 0, Real reading2 = 0)
    {
        arms.set_zero(*this, reading1, reading2);
        for (LimitMotor& m : motor) m.turns.follows = false;
    }
    void set_user_zero(Real reading1, Real reading2)
    {
        reverse ? set_zero(-reading2, reading1) : set_zero(reading1, reading2);
    }
    void set_anchor(Vec3 point) { anchor.set(*this, point), set_zero(); }
    void set_user_axis(int i, Vec3 unit) { arms.set_axis(*this, node_of(*this, i), unit), set_zero(); }

    void emit(RowWriter& out);
    void bodies_changed() { anchor.reattach(*this), set_zero(); }
    static int axes() { return 2; }
    LimitMotor* stops_of(int i) { return &motor[i]; }
    AxisMotor motor_at(int i) { return {motor[node_of(*this, i)], reverse && i == 1 ? Real(-1) : Real(1)}; }
    // Attached as (0, B), angle 2 runs against its axis.
    JointAxis axis_at(int i) const
    {
        const int own = node_of(*this, i);
        const Real sense = reverse && i == 1 ? Real(-1) : Real(1);
        const Vec3 a = sense * user_axis(i);
        return angle_among(angular_jacobian(*this, a),
                           sense * motor[own].counted(*this, arms.angle(*this, own)),
                           !motor[own].counts_turns(*this), carrier_of(own), a);
    }
    bool set_param(int param, Real value) { return motor_of(motor, param).set(param, value); }
    bool get_param(int param, Real& value) const { return motor_of(motor, param).get(param, value); }
    void state(StateStream& stream)
    {
        for (LimitMotor& m : motor) m.state(*world, stream);
    }
    void shift(Vec3 by) { anchor.shift(*this, by); }
    void structure(StructureStream& stream) { anchor.structure(stream), arms.structure(stream); }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(Universal);

void Universal::describe(DifWriter& out) const
{
    epode::describe(out, anchor);
    arms.describe_axes(out);
    arms.describe_zero(out);
    epode::describe(out, motor);
}

void Universal::emit(RowWriter& out)
{
    lock_point(*this, out, anchor);
    arms.lock_right_angle(*this, out);
    for (int i = 0; i < 2; ++i)
        motor[i].emit_angular(*this, out, arms.axis(*this, i), [&] { return arms.angle(*this, i); });
}

namespace {

void set_axis(dJointID id, int i, Vec3 axis, const char* caller)
{
    if (Universal* j = joint_for_axis<Universal>(id, axis, caller)) j->set_user_axis(i, axis);
}

void set_axis_reading(dJointID id, int i, Vec3 axis, Real angle1, Real angle2, const char* caller)
{
    Universal* j = joint_for_axis<Universal>(id, axis, Vec3{angle1, angle2, 0}, caller);
    if (!j) return;
    j->set_user_axis(i, axis);
    j->set_user_zero(angle1, angle2);
}

Real angle_of(dJointID id, int i, const char* caller)
{
    const Universal* j = attached_joint<Universal>(id, caller);
    return j ? j->user_angle(i) : 0;
}

Real rate_of(dJointID id, int i, const char* caller)
{
    const Universal* j = attached_joint<Universal>(id, caller);
    return j ? j->user_rate(i) : 0;
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateUniversal(dWorldID w, dJointGroupID g) { return create_joint<Universal>(w, g); }

void dJointSetUniversalAnchor(dJointID id, dReal x, dReal y, dReal z)
{
    if (Universal* j = joint_for_point<Universal>(id, {x, y, z})) j->set_anchor({x, y, z});
}

void dJointSetUniversalAxis1(dJointID id, dReal x, dReal y, dReal z) { set_axis(id, 0, {x, y, z}, __func__); }
void dJointSetUniversalAxis2(dJointID id, dReal x, dReal y, dReal z) { set_axis(id, 1, {x, y, z}, __func__); }

// The angles then read angle1 and angle2.
void dJointSetUniversalAxis1Offset(dJointID id, dReal x, dReal y, dReal z, dReal angle1, dReal angle2)
{
    set_axis_reading(id, 0, {x, y, z}, angle1, angle2, __func__);
}

void dJointSetUniversalAxis2Offset(dJointID id, dReal x, dReal y, dReal z, dReal angle1, dReal angle2)
{
    set_axis_reading(id, 1, {x, y, z}, angle1, angle2, __func__);
}

void dJointGetUniversalAnchor(dJointID id, dVector3 result)
{
    if (const Universal* j = joint_for_result<Universal>(id, result)) store(result, j->anchor.of_user(*j, 0));
}

void dJointGetUniversalAnchor2(dJointID id, dVector3 result)
{
    const Universal* j = checked<Universal>(id);
    if (j && demand(result, __func__)) store(result, j->anchor.of_user(*j, 1));
}

void dJointGetUniversalAxis1(dJointID id, dVector3 result)
{
    if (const Universal* j = joint_for_result<Universal>(id, result)) store(result, j->user_axis(0));
}

void dJointGetUniversalAxis2(dJointID id, dVector3 result)
{
    if (const Universal* j = joint_for_result<Universal>(id, result)) store(result, j->user_axis(1));
}

void dJointGetUniversalAngles(dJointID id, dReal* angle1, dReal* angle2)
{
    const Universal* j = checked<Universal>(id);
    if (!j) return;
    if (angle1) *angle1 = j->attached() ? j->user_angle(0) : 0;
    if (angle2) *angle2 = j->attached() ? j->user_angle(1) : 0;
}

dReal dJointGetUniversalAngle1(dJointID id) { return angle_of(id, 0, __func__); }
dReal dJointGetUniversalAngle2(dJointID id) { return angle_of(id, 1, __func__); }
dReal dJointGetUniversalAngle1Rate(dJointID id) { return rate_of(id, 0, __func__); }
dReal dJointGetUniversalAngle2Rate(dJointID id) { return rate_of(id, 1, __func__); }

void dJointAddUniversalTorques(dJointID id, dReal torque1, dReal torque2)
{
    Universal* j = joint_for_number<Universal>(id, torque1);
    if (!j || !demand(usable(torque2), __func__) || !j->attached()) return;
    const Vec3 torque = torque1 * j->user_axis(0) + torque2 * j->user_axis(1);
    add_torque(*j, j->reverse ? -torque : torque);
}

void dJointSetUniversalParam(dJointID id, int param, dReal value)
{
    set_joint_param<Universal>(id, param, value);
}
dReal dJointGetUniversalParam(dJointID id, int param) { return get_joint_param<Universal>(id, param); }

}  // extern "C"
