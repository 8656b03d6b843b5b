// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Slider: body 1 keeps its orientation against body 2 and moves along one line only.
//   C(x) = 2 vec(q1^-1 q2 q0^-1) = 0                    three rows
//          D.p = 0,  D.q = 0                            D = x2 + R2 o - x1;  p, q perpendicular to a = R1 a1
//   J    = [ p, c, -p, c ],  c = 1/2 (x2 - x1) x p      likewise q
//   stop and motor along  [ a, .., -a, .. ],  value = -D.a
// o = R2^T (x1 - x2) when the axis is set; without body 2, o is the place of body 1 in the world. Attached as
// (0, B) the sliding axis is negated, for readings, stops and motor alike.
#include "joints/access.h"

namespace epode {

struct Slider : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "slider_joint";
    Slider(const JointType& t, World& w) : LastingJoint(t, w), motor(w) {}

    Vec3 axis_local{1, 0, 0};  // in body 1
    Vec3 offset;
    Quat zero;
    LimitMotor motor;

    Vec3 axis_world() const { return direction_to_world(body1(), axis_local); }
    Vec3 motion_axis() const { return reverse ? -axis_world() : axis_world(); }
    Vec3 lag() const { return point_to_world(body2(), offset) - body1()->position(); }
    Real position() const { return -dot(motion_axis(), lag()); }
    Real rate() const { return dot(motion_axis(), relative_velocity(*this)); }

    void take_pose()
    {
        offset = point_to_local(body2(), body1()->position());
        zero = relative_orientation(*this);
    }
    void set_axis(Vec3 unit)
    {
        axis_local = direction_to_local(body1(), unit);
        take_pose();
    }

    void emit(RowWriter& out)
    {
        lock_orientation(*this, out, zero);
        Vec3 p, q;
        plane_space(axis_world(), p, q);
        out.row(sliding_jacobian(*this, p), dot(p, lag()));
        out.row(sliding_jacobian(*this, q), dot(q, lag()));
        motor.emit_linear(*this, out, motion_axis(), position());
    }
    void bodies_changed() { take_pose(); }
    static int axes() { return 1; }
    LimitMotor* stops_of(int) { return &motor; }
    AxisMotor motor_at(int) { return {motor}; }
    JointAxis axis_at(int) const
    {
        const Vec3 x2 = body2() ? body2()->position() : Vec3{};
        return {sliding_jacobian(*this, motion_axis()), position(), false, true, body1()->position(), x2};
    }
    bool set_param(int param, Real value) { return motor.set(param, value); }
    bool get_param(int param, Real& value) const { return motor.get(param, value); }
    void state(StateStream& stream) { motor.state(*world, stream); }
    void shift(Vec3 by)
    {
        if (!body2()) offset += by;
    }
    void structure(StructureStream& stream)
    {
        stream.vector(axis_local), stream.vector(offset), stream.quaternion(zero);
    }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(Slider);

void Slider::describe(DifWriter& out) const
{
    epode::describe(out, "axis", axis_local, 1);
    epode::describe(out, "qrel", zero);
    epode::describe(out, "offset", offset);
    epode::describe(out, motor);
}

}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateSlider(dWorldID w, dJointGroupID g) { return create_joint<Slider>(w, g); }

void dJointSetSliderAxis(dJointID id, dReal x, dReal y, dReal z)
{
    Vec3 axis{x, y, z};
    if (Slider* j = joint_for_axis<Slider>(id, axis)) j->set_axis(axis);
}

// With the world as second body the position then reads -(axis . (dx, dy, dz)).
void dJointSetSliderAxisDelta(dJointID id, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz)
{
    Vec3 axis{x, y, z};
    Slider* j = joint_for_axis<Slider>(id, axis, Vec3{dx, dy, dz});
    if (!j) return;
    j->set_axis(axis);
    if (!j->body2()) j->offset += Vec3{dx, dy, dz};
}

void dJointGetSliderAxis(dJointID id, dVector3 result)
{
    if (const Slider* j = joint_for_result<Slider>(id, result)) store(result, j->axis_world());
}

dReal dJointGetSliderPosition(dJointID id)
{
    const Slider* j = attached_joint<Slider>(id);
    return j ? j->position() : 0;
}

dReal dJointGetSliderPositionRate(dJointID id)
{
    const Slider* j = attached_joint<Slider>(id);
    return j ? j->rate() : 0;
}

void dJointAddSliderForce(dJointID id, dReal force)
{
    Slider* j = joint_for_number<Slider>(id, force);
    if (j && j->attached()) add_sliding_force(*j, force * j->motion_axis());
}

void dJointSetSliderParam(dJointID id, int param, dReal value) { set_joint_param<Slider>(id, param, value); }
dReal dJointGetSliderParam(dJointID id, int param) { return get_joint_param<Slider>(id, param); }

}  // extern "C"
