// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hinge-2: body 1 a chassis with a steering axis a1, body 2 a wheel with its own axis a2, one common point.
//   C(x) = d.(x2 + R2 s2 - x1 - R1 s1) = 0     d = a1 (suspension, its own ERP and CFM), then p, q
//          c0 s - s0 c = 0                     the angle between the axes stays what it was when they were
//          set:
//   s = |a1 x a2|, c = a1.a2;                  J = [ 0, n, 0, -n ],  n = a1 x a2 / s
//   stops and motor about a1; motor alone about a2.
// p, q are perpendicular to a1, so that only the first row is softened. Angle 1 is the turn of body 1 against
// body 2 about a1; angle 2 grows with the wheel's own turn about a2, opposite to its rate: ODE's convention.
#include <algorithm>

#include "joints/access.h"
#include "math/trig.h"

namespace epode {

struct Hinge2 : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "ODE_hinge2_joint";
    static constexpr bool kNeedsTwoBodies = true;
    Hinge2(const JointType& t, World& w)
        : LastingJoint(t, w), motor{LimitMotor(w), LimitMotor(w)}, suspension(w)
    {}

    AnchorPair anchor;
    Vec3 axis_local[2] = {{1, 0, 0}, {0, 1, 0}};  // each in its own body
    // Directions in body i perpendicular to axis i: the first points along the other axis when set.
    Vec3 across[2], beyond[2];
    Real s0 = 1, c0 = 0;
    LimitMotor motor[2];
    OwnSoftness suspension;

    bool complete() const { return body1() && body2(); }
    Vec3 axis(int i) const { return direction_to_world(node[i].body, axis_local[i]); }
    Axle axle(int i) const { return {axis_local[i], anchor.local[i]}; }
    Real angle(int i) const
    {
        const Vec3 other = direction_to_local(node[i].body, axis(1 - i));
        return -atan2(dot(beyond[i], other), dot(across[i], other));
    }
    Real position(int i) const { return i == 0 ? angle(0) : -angle(1); }  // whose derivative is rate(i)
    Real rate(int i) const { return dot(axis(i), relative_angular_velocity(*this)); }

    void take_pose();
    void set_anchor(Vec3 point) { anchor.set(*this, point), take_pose(); }
    void set_axes(const Vec3* a1, const Vec3* a2);
    static int axes() { return 2; }
    LimitMotor* stops_of(int i) { return i == 0 ? &motor[0] : nullptr; }
    AxisMotor motor_at(int i) { return {motor[i]}; }
    OwnSoftness* own_softness() { return &suspension; }
    JointAxis axis_at(int i) const;
    void emit(RowWriter& out);
    void bodies_changed() { anchor.reattach(*this), take_pose(); }
    bool set_param(int param, Real value);
    bool get_param(int param, Real& value) const;
    void state(StateStream& stream)
    {
        for (LimitMotor& m : motor) m.state(*world, stream);
        suspension.state(*world, stream);
    }
    void shift(Vec3 by) { anchor.shift(*this, by); }
    void structure(StructureStream& stream)
    {
        anchor.structure(stream);
        for (int i = 0; i < 2; ++i)
            for (Vec3* v : {&axis_local[i], &across[i], &beyond[i]}) stream.vector(*v);
        stream.real(s0), stream.real(c0);
    }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(Hinge2);

void Hinge2::describe(DifWriter& out) const
{
    epode::describe(out, anchor);
    for (int i = 0; i < 2; ++i) epode::describe(out, "axis", axis_local[i], i + 1);
    epode::describe(out, "v1", across[0]);
    epode::describe(out, "v2", beyond[0]);
    out.real("susp_erp", suspension.erp);
    out.real("susp_cfm", suspension.cfm);
    epode::describe(out, motor);
}

// The present directions of the axes are the zero of both angles.
void Hinge2::take_pose()
{
    for (LimitMotor& m : motor) m.turns.follows = false;
    const Vec3 a1 = axis(0), a2 = axis(1);
    s0 = length(cross(a1, a2));
    c0 = dot(a1, a2);
    for (int i = 0; i < 2; ++i) {
        const Vec3 other = direction_to_local(node[i].body, axis(1 - i));
        across[i] = other - dot(axis_local[i], other) * axis_local[i];
        if (!normalize(across[i])) across[i] = some_perpendicular(axis_local[i]);
        beyond[i] = cross(axis_local[i], across[i]);
    }
}

void Hinge2::set_axes(const Vec3* a1, const Vec3* a2)
{
    if (a1) axis_local[0] = direction_to_local(body1(), *a1);
    if (a2) axis_local[1] = direction_to_local(body2(), *a2);
    take_pose();
}

void Hinge2::emit(RowWriter& out)
{
    const Vec3 a1 = axis(0), a2 = axis(1);
    const Vec3 p1 = anchor.world(*this, 0), p2 = anchor.world(*this, 1);
    const Vec3 r1 = (world->acts_as_ode() ? p1 : p2) - body1()->position(), r2 = p2 - body2()->position();
    Vec3 p, q;
    plane_space(a1, p, q);
    out.point_at(r1, r2, RowForm::kTurned);
    suspension.apply_to(out, out.row(point_jacobian(*this, a1, r1, r2), dot(a1, p2 - p1)));
    out.row(point_jacobian(*this, p, r1, r2), dot(p, p2 - p1));
    out.row(point_jacobian(*this, q, r1, r2), dot(q, p2 - p1));

    Vec3 n = cross(a1, a2);
    const Real s = length(n), c = dot(a1, a2);
    if (!normalize(n)) n = p;
    out.row(angular_jacobian(*this, n), c0 * s - s0 * c);

    motor[0].emit_angular(*this, out, a1, [this] { return angle(0); });
    if (motor[1].turns.continuous) motor[1].follow(*this, out, position(1));
    motor[1].emit_motor(out, angular_jacobian(*this, a2));
}

// The spin is rate1 a1 + rate2 a2 of axes that need not be perpendicular: J is what takes one and leaves the
// other. Angle 2 is read against its rate. Its motor has no stops.
JointAxis Hinge2::axis_at(int i) const
{
    const Vec3 a = axis(i), other = axis(1 - i);
    const Real c = dot(a, other), s2 = std::max(1 - c * c, Real(1e-3));
    return angle_among(angular_jacobian(*this, (a - c * other) / s2), motor[i].counted(*this, position(i)),
                       !motor[i].counts_turns(*this), carrier_of(i), a);
}

bool Hinge2::set_param(int param, Real value)
{
    if ((param & 0xff00) == dParamGroup2) return motor[1].set(param & 0xff, value);
    if (param == dParamSuspensionERP) return suspension.set(dParamERP, value);
    if (param == dParamSuspensionCFM) return suspension.set(dParamCFM, value);
    return motor[0].set(param, value);
}

bool Hinge2::get_param(int param, Real& value) const
{
    if ((param & 0xff00) == dParamGroup2) return motor[1].get(param & 0xff, value);
    if (param == dParamSuspensionERP) return suspension.get(dParamERP, value);
    if (param == dParamSuspensionCFM) return suspension.get(dParamCFM, value);
    return motor[0].get(param, value);
}

namespace {

Hinge2* complete_joint(dJointID id, const char* caller)
{
    Hinge2* j = checked<Hinge2>(id, caller);
    return j && j->complete() ? j : nullptr;
}

void set_axes(dJointID id, const Real* axis1, const Real* axis2, const char* caller)
{
    Hinge2* j = checked<Hinge2>(id, caller);
    if (!j || !demand((axis1 || axis2) && j->complete(), caller)) return;
    Vec3 a1 = axis1 ? load(axis1) : j->axis(0), a2 = axis2 ? load(axis2) : j->axis(1);
    if (!demand(usable(a1) && usable(a2) && normalize(a1) && normalize(a2), caller)) return;
    // One axis at a time may pass through a parallel pair: the other axis follows in the next call.
    if (axis1 && axis2 && length(cross(a1, a2)) <= 4 * kEpsilon)
        return refuse_for(caller, "Hinge2 axes must be chosen to be linearly independent");
    j->set_axes(axis1 ? &a1 : nullptr, axis2 ? &a2 : nullptr);
}

void get_axis(dJointID id, int i, Real* result, const char* caller)
{
    const Hinge2* j = checked<Hinge2>(id, caller);
    if (j && demand(result && j->node[i].body, caller)) store(result, j->axis(i));
}

Real angle_of(dJointID id, int i, const char* caller)
{
    const Hinge2* j = complete_joint(id, caller);
    return j ? j->angle(i) : 0;
}

Real rate_of(dJointID id, int i, const char* caller)
{
    const Hinge2* j = complete_joint(id, caller);
    return j ? j->rate(i) : 0;
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateHinge2(dWorldID w, dJointGroupID g) { return create_joint<Hinge2>(w, g); }

void dJointSetHinge2Anchor(dJointID id, dReal x, dReal y, dReal z)
{
    if (Hinge2* j = joint_for_point<Hinge2>(id, {x, y, z})) j->set_anchor({x, y, z});
}

void dJointSetHinge2Axes(dJointID id, const dReal* axis1, const dReal* axis2)
{
    set_axes(id, axis1, axis2, __func__);
}

void dJointSetHinge2Axis1(dJointID id, dReal x, dReal y, dReal z)
{
    const dReal axis[3] = {x, y, z};
    set_axes(id, axis, nullptr, __func__);
}

void dJointSetHinge2Axis2(dJointID id, dReal x, dReal y, dReal z)
{
    const dReal axis[3] = {x, y, z};
    set_axes(id, nullptr, axis, __func__);
}

void dJointGetHinge2Anchor(dJointID id, dVector3 result)
{
    if (const Hinge2* j = joint_for_result<Hinge2>(id, result)) store(result, j->anchor.of_user(*j, 0));
}

void dJointGetHinge2Anchor2(dJointID id, dVector3 result)
{
    const Hinge2* j = checked<Hinge2>(id);
    if (j && demand(result, __func__)) store(result, j->anchor.of_user(*j, 1));
}

void dJointGetHinge2Axis1(dJointID id, dVector3 result) { get_axis(id, 0, result, __func__); }
void dJointGetHinge2Axis2(dJointID id, dVector3 result) { get_axis(id, 1, result, __func__); }
dReal dJointGetHinge2Angle1(dJointID id) { return angle_of(id, 0, __func__); }
dReal dJointGetHinge2Angle2(dJointID id) { return angle_of(id, 1, __func__); }
dReal dJointGetHinge2Angle1Rate(dJointID id) { return rate_of(id, 0, __func__); }
dReal dJointGetHinge2Angle2Rate(dJointID id) { return rate_of(id, 1, __func__); }

void dJointAddHinge2Torques(dJointID id, dReal torque1, dReal torque2)
{
    Hinge2* j = joint_for_number<Hinge2>(id, torque1);
    if (!j || !demand(usable(torque2), __func__) || !j->complete()) return;
    add_torque(*j, torque1 * j->axis(0) + torque2 * j->axis(1));
}

void dJointSetHinge2Param(dJointID id, int param, dReal value) { set_joint_param<Hinge2>(id, param, value); }
dReal dJointGetHinge2Param(dJointID id, int param) { return get_joint_param<Hinge2>(id, param); }

}  // extern "C"
