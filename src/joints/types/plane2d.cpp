// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Plane joint: body 1 stays in the world's plane z = 0 and turns about z only.
//   C(x)  = z1 = 0             J = [ z, 0 ]
//   w1.x  = 0,  w1.y = 0       J = [ 0, x ], [ 0, y ]
//   and, where given force: motors along [ x, .. ], [ y, .. ] and about [ 0, z ]
// The two angular rows hold rates, not angles: a tilt that the body already has stays, as in ODE, where
// clients reset the orientation now and then. Body 2, should there be one, feels only the motors.
#include "joints/access.h"

namespace epode {

struct Plane2D : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "ODE_plane2d_joint";
    Plane2D(const JointType& t, World& w) : LastingJoint(t, w), motor_x(w), motor_y(w), motor_angle(w) {}

    LimitMotor motor_x, motor_y, motor_angle;  // their stops are never tested

    void emit(RowWriter& out)
    {
        const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
        out.row({z, {}, {}, {}}, -body1()->position().z);
        out.row({{}, x, {}, {}});
        out.row({{}, y, {}, {}});
        motor_x.emit_motor(out, sliding_jacobian(*this, x));
        motor_y.emit_motor(out, sliding_jacobian(*this, y));
        motor_angle.emit_motor(out, angular_jacobian(*this, z));
    }
    void state(StateStream& stream)
    {
        for (LimitMotor* m : {&motor_x, &motor_y, &motor_angle}) m->state(*world, stream);
    }
    void structure(StructureStream&) {}
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(Plane2D);

void Plane2D::describe(DifWriter& out) const
{
    epode::describe(out, motor_x, 1);
    epode::describe(out, motor_y, 2);
    epode::describe(out, motor_angle, 3);
}

namespace {

void set_motor(dJointID id, LimitMotor Plane2D::*motor, int param, Real value, const char* caller)
{
    Plane2D* j = checked<Plane2D>(id, caller);
    if (!j || !demand(usable_param(param, value), caller)) return;
    const auto read = [&] {
        Real now = 0;
        return (j->*motor).get(param, now) ? now : 0;
    };
    change_value(*j, read, [&] { (j->*motor).set(param, value); });
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreatePlane2D(dWorldID w, dJointGroupID g) { return create_joint<Plane2D>(w, g); }

void dJointSetPlane2DXParam(dJointID id, int param, dReal value)
{
    set_motor(id, &Plane2D::motor_x, param, value, __func__);
}

void dJointSetPlane2DYParam(dJointID id, int param, dReal value)
{
    set_motor(id, &Plane2D::motor_y, param, value, __func__);
}

void dJointSetPlane2DAngleParam(dJointID id, int param, dReal value)
{
    set_motor(id, &Plane2D::motor_angle, param, value, __func__);
}

}  // extern "C"
