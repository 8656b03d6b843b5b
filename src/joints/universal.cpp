// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Universal (Cardan) joint: a common point, and an axis a1 fixed in body 1 perpendicular to a2 fixed in
// body 2.
//   C(x) = x2 + R2 s2 - x1 - R1 s1 = 0       three rows of a ball
//          -a1.a2 = 0                        J = [ 0, n, 0, -n ],  n = a1 x a2 / |a1 x a2|
//   stops and motors along a1 and a2.
// Angles are those of a cross whose arms are a1 and a2: angle 1 turns body 1 against the cross about a1,
// angle 2 the cross against body 2 about a2. Attached as (0, B), the client's axis 1 is the internal axis 2
// (the world's), angle1 = internal angle2, angle2 = -internal angle1; stops and motors keep internal numbers.
#include "joints/access.h"
#include "math/rotation.h"

namespace epode {

struct Universal : Joint {
    static constexpr int kMaxRows = 6;
    Universal(const JointType& t, World& w) : Joint(t, w), motor{LimitMotor(w), LimitMotor(w)} {}

    AnchorPair anchor;
    Vec3 axis_local[2] = {{1, 0, 0}, {0, 1, 0}};  // each in its own body
    Quat zero[2];
    LimitMotor motor[2];

    Vec3 axis(int i) const { return direction_to_world(node[i].body, axis_local[i]); }
    Vec3 user_axis(int i) const { return axis(node_of(*this, i)); }

    // The cross with its first arm exactly on axis i and the second nearly on the other.
    Quat cross_orientation(int i) const
    {
        Mat3 R;
        const Vec3 a = axis(i);
        if (!rotation_from_axes(a, axis(1 - i), R)) rotation_from_axes(a, some_perpendicular(a), R);
        return to_quat(R);
    }
    // Rotation of body i against the cross about axis i; the second angle has the opposite sense.
    Real body_angle(int i) const
    {
        return hinge_angle(orientation_of(node[i].body), cross_orientation(i), zero[i], axis_local[i]);
    }
    Real angle(int i) const { return i == 0 ? body_angle(0) : -body_angle(1); }
    Real user_angle(int i) const { return !reverse ? angle(i) : i == 0 ? angle(1) : -angle(0); }
    Real user_rate(int i) const { return dot(user_axis(i), relative_angular_velocity(*this)); }

    void set_zero(Real reading1 = 0, Real reading2 = 0)
    {
        const Real reading[2] = {reading1, -reading2};
        for (int i = 0; i < 2; ++i)
            zero[i] =
                hinge_zero(orientation_of(node[i].body), cross_orientation(i), axis_local[i], reading[i]);
    }
    void set_user_zero(Real reading1, Real reading2)
    {
        reverse ? set_zero(-reading2, reading1) : set_zero(reading1, reading2);
    }
    void set_anchor(Vec3 point) { anchor.set(*this, point), set_zero(); }
    void set_user_axis(int i, Vec3 unit)
    {
        const int k = node_of(*this, i);
        axis_local[k] = direction_to_local(node[k].body, unit);
        set_zero();
    }

    void emit(RowWriter& out);
    void bodies_changed() { anchor.reattach(*this), set_zero(); }
    LimitMotor& motor_of(int& param);
    bool set_param(int param, Real value)
    {
        LimitMotor& m = motor_of(param);
        return m.set(param, value);
    }
    bool get_param(int param, Real& value) const
    {
        const LimitMotor& m = const_cast<Universal*>(this)->motor_of(param);
        return m.get(param, value);
    }
};

JOINT_DEFINE(Universal);

void Universal::emit(RowWriter& out)
{
    lock_point(*this, out, anchor);
    const Vec3 a1 = axis(0), a2 = axis(1);
    const Vec3 n = normalized_or(cross(a1, a2), some_perpendicular(a1));
    out.row(angular_jacobian(*this, n), -dot(a1, a2));
    for (int i = 0; i < 2; ++i)
        motor[i].emit_angular(*this, out, axis(i), motor[i].has_stops() ? angle(i) : 0);
}

// Numbers of group 2 lose their group; all others go to the first axis as they are.
LimitMotor& Universal::motor_of(int& param)
{
    if ((param & 0xff00) != dParamGroup2) return motor[0];
    param &= 0xff;
    return motor[1];
}

namespace {

void set_axis(dJointID id, int i, Vec3 axis, const char* caller)
{
    if (Universal* j = joint_for_axis<Universal>(id, axis, caller)) j->set_user_axis(i, axis);
}

void set_axis_reading(dJointID id, int i, Vec3 axis, Real angle1, Real angle2, const char* caller)
{
    Universal* j = joint_for_axis<Universal>(id, axis, caller);
    if (!j || !demand(usable(angle1) && usable(angle2), caller)) return;
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
    const Universal* j = attached_joint<Universal>(id);
    if (angle1) *angle1 = j ? j->user_angle(0) : 0;
    if (angle2) *angle2 = j ? j->user_angle(1) : 0;
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
