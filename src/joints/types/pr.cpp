// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// PR: prismatic and rotoid. Body 2 turns about an axis a of both bodies through its anchor, and the anchor
// slides along a line s of body 1; s and a are meant to be perpendicular.
//   C(x) = (a1 x a2).p = 0,  (a1 x a2).t = 0      t = a1 x s / |a1 x s|,  p = t x a1 (= s)
//          t.g = 0,  (s x t).g = 0                g = x2 + R2 s2 - x1 - R1 s1: the gap between the anchors
//   J    = [ 0, d, 0, -d ]  for d = p, t;         [ d, D x d, -d, -(r2 x d) ]  for d = t, s x t,
//                                                 D = x2 + R2 s2 - x1
//   stops and motors along s (value -s.g) and about a1. Those along s act where the anchors are: between the
//   bodies' centres, as in ODE, they would turn a body that hangs off its slide, and do work on it.
// Axes that are not perpendicular, which ODE forbids without a check, still make a sound joint here: turning
// is locked across a, sliding across s. Attached as (0, B), position and angle change sign; the stop of the
// position follows the reading, that of the angle keeps the sign of node 0, as in ODE.
#include "joints/access.h"

namespace epode {

struct PR : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "PR_joint";
    PR(const JointType& t, World& w) : LastingJoint(t, w), motor{LimitMotor(w), LimitMotor(w)} {}

    AnchorPair anchor;
    Vec3 slide_local{0, 1, 0};  // in body 1
    AxisPair axis{{{1, 0, 0}, {1, 0, 0}}};
    Quat zero;            // of the angle
    LimitMotor motor[2];  // of the position, of the angle

    Real sign() const { return reverse ? Real(-1) : Real(1); }
    Vec3 slide() const { return direction_to_world(body1(), slide_local); }
    Vec3 slide_motion() const { return sign() * slide(); }
    Vec3 turn() const { return axis.world(*this, 0); }
    Real position() const { return dot(slide_motion(), anchor.world(*this, 0) - anchor.world(*this, 1)); }
    // As ODE reads it: without the turning of body 1, about whose centre the slide swings.
    Real position_rate() const
    {
        Jacobian row = separated_jacobian(*this, anchor, slide_motion());
        row.ang1 = {};
        return rate_along(*this, row);
    }
    Real angle() const
    {
        return hinge_angle(orientation_of(body1()), orientation_of(body2()), zero, axis.local[0]);
    }
    Real angle_rate() const { return dot(turn(), relative_angular_velocity(*this)); }
    void set_zero()
    {
        zero = hinge_zero(orientation_of(body1()), orientation_of(body2()), axis.local[0]);
        motor[1].turns.follows = false;
    }
    void set_slide(Vec3 unit) { slide_local = direction_to_local(body1(), unit), set_zero(); }
    void set_turn(Vec3 unit) { axis.set(*this, unit), set_zero(); }

    void emit(RowWriter& out);
    void bodies_changed()
    {
        anchor.set(*this, anchor.world(*this, 1));
        axis.reattach(*this);
        set_zero();
    }
    static int axes() { return 2; }
    LimitMotor* stops_of(int i) { return &motor[i]; }
    AxisMotor motor_at(int i) { return {motor[i], i == 0 ? Real(1) : sign()}; }
    JointAxis axis_at(int i) const
    {
        if (i == 0) return separated_axis(*this, anchor, slide_motion(), position());
        return {angular_jacobian(*this, sign() * turn()), sign() * motor[1].counted(*this, angle()),
                !motor[1].counts_turns(*this)};
    }
    bool set_param(int param, Real value) { return motor_of(motor, param).set(param, value); }
    bool get_param(int param, Real& value) const { return motor_of(motor, param).get(param, value); }
    void state(StateStream& stream)
    {
        for (LimitMotor& m : motor) m.state(*world, stream);
    }
    void shift(Vec3 by) { anchor.shift(*this, by); }
    void structure(StructureStream& stream)
    {
        anchor.structure(stream), axis.structure(stream);
        stream.vector(slide_local), stream.quaternion(zero);
    }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(PR);

void PR::describe(DifWriter& out) const
{
    epode::describe(out, "anchor2", anchor.local[1]);
    epode::describe(out, "axisR1", axis.local[0]);
    epode::describe(out, "axisR2", axis.local[1]);
    epode::describe(out, "axisP1", slide_local);
    epode::describe(out, "qrel", zero);
    epode::describe(out, "offset", anchor.local[0]);
    epode::describe(out, motor);
}

void PR::emit(RowWriter& out)
{
    const Vec3 s = slide(), a1 = turn(), u = cross(a1, axis.world(*this, 1));
    const Vec3 t = normalized_or(cross(a1, s), some_perpendicular(a1)), p = cross(t, a1);
    out.row(angular_jacobian(*this, p), dot(u, p));
    out.row(angular_jacobian(*this, t), dot(u, t));
    lock_level(*this, out, anchor, cross(s, t));
    lock_level(*this, out, anchor, t);
    const Jacobian along = separated_jacobian(*this, anchor, slide_motion());
    motor[0].emit(*this, out, along, position(), rate_along(*this, along));
    motor[1].emit_angular(*this, out, a1, [this] { return angle(); });
}

}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreatePR(dWorldID w, dJointGroupID g) { return create_joint<PR>(w, g); }

// The position then reads zero; the angle keeps its zero.
void dJointSetPRAnchor(dJointID id, dReal x, dReal y, dReal z)
{
    if (PR* j = joint_for_point<PR>(id, {x, y, z})) j->anchor.set(*j, {x, y, z});
}

void dJointSetPRAxis1(dJointID id, dReal x, dReal y, dReal z)
{
    Vec3 axis{x, y, z};
    if (PR* j = joint_for_axis<PR>(id, axis)) j->set_slide(axis);
}

void dJointSetPRAxis2(dJointID id, dReal x, dReal y, dReal z)
{
    Vec3 axis{x, y, z};
    if (PR* j = joint_for_axis<PR>(id, axis)) j->set_turn(axis);
}

// The anchor that body 2, or the world, carries: the place of the rotoid.
void dJointGetPRAnchor(dJointID id, dVector3 result)
{
    if (const PR* j = joint_for_result<PR>(id, result)) store(result, j->anchor.world(*j, 1));
}

void dJointGetPRAxis1(dJointID id, dVector3 result)
{
    if (const PR* j = joint_for_result<PR>(id, result)) store(result, j->slide());
}

void dJointGetPRAxis2(dJointID id, dVector3 result)
{
    if (const PR* j = joint_for_result<PR>(id, result)) store(result, j->turn());
}

dReal dJointGetPRPosition(dJointID id)
{
    const PR* j = attached_joint<PR>(id);
    return j ? j->position() : 0;
}

dReal dJointGetPRPositionRate(dJointID id)
{
    const PR* j = attached_joint<PR>(id);
    return j ? j->position_rate() : 0;
}

dReal dJointGetPRAngle(dJointID id)
{
    const PR* j = attached_joint<PR>(id);
    return j ? j->sign() * j->angle() : 0;
}

dReal dJointGetPRAngleRate(dJointID id)
{
    const PR* j = attached_joint<PR>(id);
    return j ? j->sign() * j->angle_rate() : 0;
}

void dJointAddPRTorque(dJointID id, dReal torque)
{
    PR* j = joint_for_number<PR>(id, torque);
    if (j && j->attached()) add_torque(*j, j->sign() * torque * j->turn());
}

void dJointSetPRParam(dJointID id, int param, dReal value) { set_joint_param<PR>(id, param, value); }
dReal dJointGetPRParam(dJointID id, int param) { return get_joint_param<PR>(id, param); }

}  // extern "C"
