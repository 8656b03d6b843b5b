// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// PU: prismatic and universal. A universal joint (axis a1 of body 1, a2 of body 2) whose anchor slides along
// a line s of body 1.
//   -a1.a2 = 0                    and angles: see cross.h
//   p.g = 0,  q.g = 0             g = x2 + R2 s2 - x1 - R1 s1: the gap between the anchors; p, q
//   perpendicular to s J    = [ d, D x d, -d, -(r2 x d) ],  D = x2 + R2 s2 - x1,  for d = p, q, and s for
//   stop and motor stops and motors about a1, about a2, and along s (value -s.g).
// Both bodies feel the force at body 2's anchor. ODE lets each feel it at its own, which turns the pair by
// g x force: a free pair that is drawn out would begin to spin.
// Attached as (0, B), the client's axis 1 is the internal axis 2 and angles follow without a change of sign;
// the position changes sign, and its stop follows the reading.
#include "joints/access.h"
#include "joints/types/cross.h"

namespace epode {

struct PU : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "PU_joint";
    PU(const JointType& t, World& w) : LastingJoint(t, w), motor{LimitMotor(w), LimitMotor(w), LimitMotor(w)}
    {}

    AnchorPair anchor;
    Cross arms{{{0, 1, 0}, {0, 0, 1}}, {}};
    Vec3 slide_local{1, 0, 0};  // in body 1
    LimitMotor motor[3];        // of the angles, of the position

    Real sign() const { return reverse ? Real(-1) : Real(1); }
    Vec3 slide() const { return direction_to_world(body1(), slide_local); }
    Vec3 slide_motion() const { return sign() * slide(); }
    Real position() const { return dot(slide_motion(), anchor.world(*this, 0) - anchor.world(*this, 1)); }
    // As ODE reads it: with the turning of body 2 counted the other way round. Stop and motor take the true
    // rate.
    Real position_rate() const
    {
        Jacobian row = separated_jacobian(*this, anchor, slide_motion());
        row.ang2 = -row.ang2;
        return rate_along(*this, row);
    }
    Vec3 user_axis(int i) const { return arms.axis(*this, node_of(*this, i)); }
    Axle axle(int i) const { return {arms.local[i], anchor.local[i]}; }
    Real user_angle(int i) const { return arms.angle(*this, node_of(*this, i)); }
    Real user_rate(int i) const { return arms.rate(*this, node_of(*this, i)); }

    void set_anchor(Vec3 point1, Vec3 point2)
    {
        anchor.local[0] = point_to_local(body1(), point1);
        anchor.local[1] = point_to_local(body2(), point2);
        set_zero();
    }
    void set_zero()
    {
        arms.set_zero(*this);
        for (LimitMotor& m : motor) m.turns.follows = false;
    }
    void set_user_axis(int i, Vec3 unit) { arms.set_axis(*this, node_of(*this, i), unit), set_zero(); }
    void set_slide(Vec3 unit) { slide_local = direction_to_local(body1(), unit), set_zero(); }

    void emit(RowWriter& out);
    void bodies_changed()
    {
        const Vec3 p = anchor.world(*this, 1);
        set_anchor(p, p);
    }
    static int axes() { return 3; }
    LimitMotor* stops_of(int i) { return &motor[i]; }
    AxisMotor motor_at(int i) { return {motor[i == 2 ? i : node_of(*this, i)]}; }
    JointAxis axis_at(int i) const
    {
        if (i == 2) return separated_axis(*this, anchor, slide_motion(), position());
        const int own = node_of(*this, i);
        const Vec3 a = user_axis(i);
        return angle_among(angular_jacobian(*this, a), motor[own].counted(*this, arms.angle(*this, own)),
                           !motor[own].counts_turns(*this), carrier_of(own), a);
    }
    bool set_param(int param, Real value) { return set_by_group(motor, param, value); }
    bool get_param(int param, Real& value) const { return get_by_group(motor, param, value); }
    void state(StateStream& stream)
    {
        for (LimitMotor& m : motor) m.state(*world, stream);
    }
    void shift(Vec3 by) { anchor.shift(*this, by); }
    void structure(StructureStream& stream)
    {
        anchor.structure(stream), arms.structure(stream), stream.vector(slide_local);
    }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(PU);

void PU::describe(DifWriter& out) const
{
    epode::describe(out, anchor);
    arms.describe_axes(out);
    epode::describe(out, "axisP", slide_local);
    arms.describe_zero(out);
    epode::describe(out, motor);
}

void PU::emit(RowWriter& out)
{
    Vec3 p, q;
    plane_space(slide(), p, q);
    arms.lock_right_angle(*this, out);
    lock_level(*this, out, anchor, p);
    lock_level(*this, out, anchor, q);
    for (int i = 0; i < 2; ++i)
        motor[i].emit_angular(*this, out, arms.axis(*this, i), [&] { return arms.angle(*this, i); });
    const Jacobian along = separated_jacobian(*this, anchor, slide_motion());
    motor[2].emit(*this, out, along, position(), rate_along(*this, along));
}

namespace {

void set_axis(dJointID id, int i, Vec3 axis, const char* caller)
{
    if (PU* j = joint_for_axis<PU>(id, axis, caller)) j->set_user_axis(i, axis);
}

void set_slide(dJointID id, Vec3 axis, const char* caller)
{
    if (PU* j = joint_for_axis<PU>(id, axis, caller)) j->set_slide(axis);
}

void get_slide(dJointID id, Real* result, const char* caller)
{
    if (const PU* j = joint_for_result<PU>(id, result, caller)) store(result, j->slide());
}

Real angle_of(dJointID id, int i, const char* caller)
{
    const PU* j = attached_joint<PU>(id, caller);
    return j ? j->user_angle(i) : 0;
}

Real rate_of(dJointID id, int i, const char* caller)
{
    const PU* j = attached_joint<PU>(id, caller);
    return j ? j->user_rate(i) : 0;
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreatePU(dWorldID w, dJointGroupID g) { return create_joint<PU>(w, g); }

void dJointSetPUAnchor(dJointID id, dReal x, dReal y, dReal z)
{
    const Vec3 p{x, y, z};
    if (PU* j = joint_for_point<PU>(id, p)) j->set_anchor(p, p);
}

// The position then reads axis 3 . (dx, dy, dz).
void dJointSetPUAnchorOffset(dJointID id, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz)
{
    const Vec3 p{x, y, z}, d{dx, dy, dz};
    if (PU* j = joint_for_point<PU>(id, p, d)) j->set_anchor(p + j->sign() * d, p);
}

void dJointSetPUAnchorDelta(dJointID id, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz)
{
    const Vec3 p{x, y, z}, d{dx, dy, dz};
    if (PU* j = joint_for_point<PU>(id, p, d)) j->set_anchor(p - d, p);
}

void dJointSetPUAxis1(dJointID id, dReal x, dReal y, dReal z) { set_axis(id, 0, {x, y, z}, __func__); }
void dJointSetPUAxis2(dJointID id, dReal x, dReal y, dReal z) { set_axis(id, 1, {x, y, z}, __func__); }
void dJointSetPUAxis3(dJointID id, dReal x, dReal y, dReal z) { set_slide(id, {x, y, z}, __func__); }
void dJointSetPUAxisP(dJointID id, dReal x, dReal y, dReal z) { set_slide(id, {x, y, z}, __func__); }

void dJointGetPUAnchor(dJointID id, dVector3 result)
{
    if (const PU* j = joint_for_result<PU>(id, result)) store(result, j->anchor.world(*j, 1));
}

void dJointGetPUAxis1(dJointID id, dVector3 result)
{
    if (const PU* j = joint_for_result<PU>(id, result)) store(result, j->user_axis(0));
}

void dJointGetPUAxis2(dJointID id, dVector3 result)
{
    if (const PU* j = joint_for_result<PU>(id, result)) store(result, j->user_axis(1));
}

void dJointGetPUAxis3(dJointID id, dVector3 result) { get_slide(id, result, __func__); }
void dJointGetPUAxisP(dJointID id, dVector3 result) { get_slide(id, result, __func__); }

dReal dJointGetPUPosition(dJointID id)
{
    const PU* j = attached_joint<PU>(id);
    return j ? j->position() : 0;
}

dReal dJointGetPUPositionRate(dJointID id)
{
    const PU* j = attached_joint<PU>(id);
    return j ? j->position_rate() : 0;
}

void dJointGetPUAngles(dJointID id, dReal* angle1, dReal* angle2)
{
    const PU* j = checked<PU>(id);
    if (!j) return;
    if (angle1) *angle1 = j->attached() ? j->user_angle(0) : 0;
    if (angle2) *angle2 = j->attached() ? j->user_angle(1) : 0;
}

dReal dJointGetPUAngle1(dJointID id) { return angle_of(id, 0, __func__); }
dReal dJointGetPUAngle2(dJointID id) { return angle_of(id, 1, __func__); }
dReal dJointGetPUAngle1Rate(dJointID id) { return rate_of(id, 0, __func__); }
dReal dJointGetPUAngle2Rate(dJointID id) { return rate_of(id, 1, __func__); }

void dJointSetPUParam(dJointID id, int param, dReal value) { set_joint_param<PU>(id, param, value); }
dReal dJointGetPUParam(dJointID id, int param) { return get_joint_param<PU>(id, param); }

}  // extern "C"
