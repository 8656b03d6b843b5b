// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Piston: body 1 slides along one axis a and turns about it.
//   C(x) = (a1 x a2).p = 0,  (a1 x a2).q = 0      a1 = R1 a;  p, q perpendicular to a1
//          p.g = 0,  q.g = 0                      g = x2 + R2 s2 - x1 - R1 s1: the gap between the anchors
//   J    = [ 0, d, 0, -d ]  and  [ d, D x d, -d, -(r2 x d) ],  D = x2 + R2 s2 - x1,  for d = p, q
//   stops and motors along a1 (value -a1.g) and about a1.
// Attached as (0, B), position and angle change sign; the stop of the position follows the reading, that of
// the angle keeps the sign of node 0, as in ODE.
#include "joints/access.h"

namespace epode {

struct Piston : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "piston_joint";
    Piston(const JointType& t, World& w) : LastingJoint(t, w), motor{LimitMotor(w), LimitMotor(w)} {}

    AnchorPair anchor;
    AxisPair axis{{{1, 0, 0}, {1, 0, 0}}};
    Quat zero;            // of the angle
    LimitMotor motor[2];  // of the position, of the angle

    Real sign() const { return reverse ? Real(-1) : Real(1); }
    Vec3 axis_world() const { return axis.world(*this, 0); }
    Axle axle(int i) const { return {axis.local[i], anchor.local[i], true}; }
    Vec3 motion_axis() const { return sign() * axis_world(); }
    Real position() const { return dot(motion_axis(), anchor.world(*this, 0) - anchor.world(*this, 1)); }
    Real position_rate() const { return dot(motion_axis(), relative_velocity(*this)); }
    Real angle() const
    {
        return hinge_angle(orientation_of(body1()), orientation_of(body2()), zero, axis.local[0]);
    }
    Real angle_rate() const { return dot(axis_world(), relative_angular_velocity(*this)); }
    void set_zero()
    {
        zero = hinge_zero(orientation_of(body1()), orientation_of(body2()), axis.local[0]);
        motor[1].turns.follows = false;
    }
    void set_axis(Vec3 unit) { axis.set(*this, unit), set_zero(); }
    void set_anchor(Vec3 point1, Vec3 point2)
    {
        anchor.local[0] = point_to_local(body1(), point1);
        anchor.local[1] = point_to_local(body2(), point2);
        set_zero();
    }

    void emit(RowWriter& out);
    void bodies_changed() { anchor.reattach(*this), axis.reattach(*this), set_zero(); }
    static int axes() { return 2; }
    LimitMotor* stops_of(int i) { return &motor[i]; }
    AxisMotor motor_at(int i) { return {motor[i], i == 0 ? Real(1) : sign()}; }
    JointAxis axis_at(int i) const
    {
        if (i == 0) return separated_axis(*this, anchor, motion_axis(), position());
        return {angular_jacobian(*this, sign() * axis_world()), sign() * motor[1].counted(*this, angle()),
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
        anchor.structure(stream), axis.structure(stream), stream.quaternion(zero);
    }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(Piston);

void Piston::describe(DifWriter& out) const
{
    epode::describe(out, anchor);
    epode::describe(out, axis);
    epode::describe(out, "qrel", zero);
    epode::describe(out, motor);
}

void Piston::emit(RowWriter& out)
{
    lock_axis(*this, out, axis);
    Vec3 p, q;
    plane_space(axis_world(), p, q);
    lock_level(*this, out, anchor, p);
    lock_level(*this, out, anchor, q);
    motor[0].emit_linear(*this, out, motion_axis(), position());
    motor[1].emit_angular(*this, out, axis_world(), [this] { return angle(); });
}

}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreatePiston(dWorldID w, dJointGroupID g) { return create_joint<Piston>(w, g); }

void dJointSetPistonAnchor(dJointID id, dReal x, dReal y, dReal z)
{
    const Vec3 p{x, y, z};
    if (Piston* j = joint_for_point<Piston>(id, p)) j->set_anchor(p, p);
}

// The position then reads axis . (dx, dy, dz).
void dJointSetPistonAnchorOffset(dJointID id, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz)
{
    const Vec3 p{x, y, z}, d{dx, dy, dz};
    if (Piston* j = joint_for_point<Piston>(id, p, d)) j->set_anchor(p + j->sign() * d, p);
}

void dJointSetPistonAxis(dJointID id, dReal x, dReal y, dReal z)
{
    Vec3 axis{x, y, z};
    if (Piston* j = joint_for_axis<Piston>(id, axis)) j->set_axis(axis);
}

// ODE's meaning, of little use: the vector from body 1 to its own anchor becomes x1 - x2 - (dx, dy, dz).
void dJointSetPistonAxisDelta(dJointID id, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz)
{
    Vec3 axis{x, y, z};
    const Vec3 d{dx, dy, dz};
    Piston* j = joint_for_axis<Piston>(id, axis, d);
    if (!j) return;
    j->set_axis(axis);
    const Vec3 apart = j->body1()->position() - (j->body2() ? j->body2()->position() : Vec3{});
    j->anchor.local[0] = direction_to_local(j->body1(), apart - d);
}

void dJointGetPistonAnchor(dJointID id, dVector3 result)
{
    if (const Piston* j = joint_for_result<Piston>(id, result)) store(result, j->anchor.of_user(*j, 0));
}

void dJointGetPistonAnchor2(dJointID id, dVector3 result)
{
    const Piston* j = checked<Piston>(id);
    if (j && demand(result, __func__)) store(result, j->anchor.of_user(*j, 1));
}

void dJointGetPistonAxis(dJointID id, dVector3 result)
{
    if (const Piston* j = joint_for_result<Piston>(id, result)) store(result, j->axis_world());
}

dReal dJointGetPistonPosition(dJointID id)
{
    const Piston* j = attached_joint<Piston>(id);
    return j ? j->position() : 0;
}

dReal dJointGetPistonPositionRate(dJointID id)
{
    const Piston* j = attached_joint<Piston>(id);
    return j ? j->position_rate() : 0;
}

dReal dJointGetPistonAngle(dJointID id)
{
    const Piston* j = attached_joint<Piston>(id);
    return j ? j->sign() * j->angle() : 0;
}

dReal dJointGetPistonAngleRate(dJointID id)
{
    const Piston* j = attached_joint<Piston>(id);
    return j ? j->sign() * j->angle_rate() : 0;
}

void dJointAddPistonForce(dJointID id, dReal force)
{
    Piston* j = joint_for_number<Piston>(id, force);
    if (j && j->attached()) add_force_at(*j, j->anchor, force * j->motion_axis());
}

void dJointSetPistonParam(dJointID id, int param, dReal value) { set_joint_param<Piston>(id, param, value); }
dReal dJointGetPistonParam(dJointID id, int param) { return get_joint_param<Piston>(id, param); }

}  // extern "C"
