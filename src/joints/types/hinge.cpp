// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hinge: an anchor and an axis in common.
//   C(x) = x2 + R2 s2 - x1 - R1 s1 = 0                  three rows of a ball
//          (a1 x a2).p = 0,  (a1 x a2).q = 0            a1 = R1 a; p, q perpendicular to a1
//   J    = [ 0, p, 0, -p ],  [ 0, q, 0, -q ]
//   stop and motor along  [ 0, a1, 0, -a1 ],  value = rotation of body 1 against body 2 about a1
// Attached as (0, B), a client reads the angle and its rate negated, but stops and motor keep the sign of
// node 0: visible behaviour of ODE.
#include "joints/access.h"
#include "joints/reading.h"
#include "math/rotation.h"

namespace epode {

struct Hinge : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "hinge_joint";
    Hinge(const JointType& t, World& w) : LastingJoint(t, w), motor(w) {}

    AnchorPair anchor;
    AxisPair axis{{{1, 0, 0}, {1, 0, 0}}};
    Quat zero;  // q1^-1 q2 where the angle is zero
    LimitMotor motor;

    Real sign() const { return reverse ? Real(-1) : Real(1); }
    Vec3 axis_world() const { return axis.world(*this, 0); }
    Axle axle(int i) const { return {axis.local[i], anchor.local[i], true}; }
    Real angle() const
    {
        const Turn now{orientation_of(body1()), orientation_of(body2()), zero, axis.local[0]};
        return angle_.of(now, [&] { return hinge_angle(now.q1, now.q2, now.zero, now.axis); });
    }
    Real rate() const { return dot(axis_world(), relative_angular_velocity(*this)); }
    void set_zero() { zero = relative_orientation(*this), motor.turns.follows = false; }
    void set_zero_beyond(Vec3 unit, Real offset)
    {
        zero = rotation_about(unit, -sign() * offset) * conjugate(relative_orientation(*this));
    }
    void set_anchor(Vec3 point) { anchor.set(*this, point), set_zero(); }
    void set_axis(Vec3 unit) { axis.set(*this, unit), set_zero(); }

    void emit(RowWriter& out)
    {
        lock_point(*this, out, anchor);
        lock_axis(*this, out, axis);
        motor.emit_angular(*this, out, axis_world(), [this] { return angle(); });
    }
    void bodies_changed()
    {
        anchor.reattach(*this);
        axis.reattach(*this);
        set_zero();
    }
    static int axes() { return 1; }
    LimitMotor* stops_of(int) { return &motor; }
    AxisMotor motor_at(int) { return {motor, sign()}; }
    JointAxis axis_at(int) const
    {
        return {angular_jacobian(*this, sign() * axis_world()), sign() * motor.counted(*this, angle()),
                !motor.counts_turns(*this)};
    }
    bool set_param(int param, Real value) { return motor.set(param, value); }
    bool get_param(int param, Real& value) const { return motor.get(param, value); }
    void state(StateStream& stream) { motor.state(*world, stream); }
    void shift(Vec3 by) { anchor.shift(*this, by); }
    void structure(StructureStream& stream)
    {
        anchor.structure(stream), axis.structure(stream), stream.quaternion(zero);
    }
    void describe(DifWriter& out) const;

  private:
    // What an angle follows from.
    struct Turn {
        Quat q1, q2, zero;
        Vec3 axis;
    };
    Reading<Turn, Real> angle_;
};

JOINT_DEFINE(Hinge);

void Hinge::describe(DifWriter& out) const
{
    epode::describe(out, anchor);
    epode::describe(out, axis);
    epode::describe(out, "qrel", zero);
    epode::describe(out, motor);
}

}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateHinge(dWorldID w, dJointGroupID g) { return create_joint<Hinge>(w, g); }

void dJointSetHingeAnchor(dJointID id, dReal x, dReal y, dReal z)
{
    if (Hinge* j = joint_for_point<Hinge>(id, {x, y, z})) j->set_anchor({x, y, z});
}

// With the world as second body its anchor lies at the given point plus (ax, ay, az).
void dJointSetHingeAnchorDelta(dJointID id, dReal x, dReal y, dReal z, dReal ax, dReal ay, dReal az)
{
    Hinge* j = joint_for_point<Hinge>(id, {x, y, z}, Vec3{ax, ay, az});
    if (!j) return;
    j->set_anchor({x, y, z});
    if (!j->body2()) j->anchor.local[1] = Vec3{x, y, z} + Vec3{ax, ay, az};
}

void dJointSetHingeAxis(dJointID id, dReal x, dReal y, dReal z)
{
    Vec3 axis{x, y, z};
    if (Hinge* j = joint_for_axis<Hinge>(id, axis)) j->set_axis(axis);
}

// A body that is turned by `angle` about the axis reads it: that is what programs call this for. In general
// ODE's zero is the opposite of the relative turn, so the reading is twice the turn less the given angle; and
// the shift is about the axis as given in the world, also where body 1 leans.
void dJointSetHingeAxisOffset(dJointID id, dReal x, dReal y, dReal z, dReal angle)
{
    Vec3 axis{x, y, z};
    if (Hinge* j = joint_for_axis<Hinge>(id, axis, Vec3{angle, 0, 0}))
        j->set_axis(axis), j->set_zero_beyond(axis, angle);
}

void dJointGetHingeAnchor(dJointID id, dVector3 result)
{
    if (const Hinge* j = joint_for_result<Hinge>(id, result)) store(result, j->anchor.of_user(*j, 0));
}

void dJointGetHingeAnchor2(dJointID id, dVector3 result)
{
    const Hinge* j = checked<Hinge>(id);
    if (j && demand(result, __func__)) store(result, j->anchor.of_user(*j, 1));
}

void dJointGetHingeAxis(dJointID id, dVector3 result)
{
    if (const Hinge* j = joint_for_result<Hinge>(id, result)) store(result, j->axis_world());
}

dReal dJointGetHingeAngle(dJointID id)
{
    const Hinge* j = attached_joint<Hinge>(id);
    return j ? j->sign() * j->angle() : 0;
}

dReal dJointGetHingeAngleRate(dJointID id)
{
    const Hinge* j = attached_joint<Hinge>(id);
    return j ? j->sign() * j->rate() : 0;
}

void dJointAddHingeTorque(dJointID id, dReal torque)
{
    Hinge* j = joint_for_number<Hinge>(id, torque);
    if (j && j->attached()) add_torque(*j, j->sign() * torque * j->axis_world());
}

void dJointSetHingeParam(dJointID id, int param, dReal value) { set_joint_param<Hinge>(id, param, value); }
dReal dJointGetHingeParam(dJointID id, int param) { return get_joint_param<Hinge>(id, param); }

}  // extern "C"
