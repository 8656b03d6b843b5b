// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Linear motor: up to three axes along which the relative velocity of the two centres is driven; no anchor,
// no stops.
//   rows  J = [ a, c, -a, c ],  c = 1/2 (x2 - x1) x a,  a = axis i, given in the world, body 1 or body 2
//         J v = vel_i,  |lambda| <= fmax_i
// Stops are kept as numbers but never tested: without an anchor there is no position to test. An axis that
// was never set is zero and writes no row. The axis is read back as it is stored, in the frame it moves with:
// ODE's clients know it so.
#include "joints/access.h"

namespace epode {

struct LMotor : LastingJoint {
    static constexpr int kMaxRows = 3;
    static constexpr const char* kDifName = "ODE_linear_motor_joint";
    LMotor(const JointType& t, World& w)
        : LastingJoint(t, w), motor{LimitMotor(w), LimitMotor(w), LimitMotor(w)}
    {}

    int count = 0;
    int rel[3] = {0, 0, 0};  // 0 world, 1 body 1, 2 body 2
    Vec3 axis_local[3];
    LimitMotor motor[3];

    const Body* frame(int r) const { return r == 0 ? nullptr : node[r - 1].body; }

    void set_axis(int i, int r, Vec3 unit)
    {
        rel[i] = r == 2 && !body2() ? 1 : r;
        axis_local[i] = direction_to_local(frame(rel[i]), unit);
    }

    void emit(RowWriter& out)
    {
        for (int i = 0; i < count; ++i) {
            const Vec3 axis = direction_to_world(frame(rel[i]), axis_local[i]);
            if (length2(axis) > 0) motor[i].emit_motor(out, sliding_jacobian(*this, axis));
        }
    }

    int axes() const { return count; }
    AxisMotor motor_at(int i) { return {motor[i]}; }
    // Exact while neither body turns the axis.
    JointAxis axis_at(int i) const
    {
        const Vec3 a = direction_to_world(frame(rel[i]), axis_local[i]);
        const Vec3 x2 = body2() ? body2()->position() : Vec3{};
        return {sliding_jacobian(*this, a), dot(a, body1()->position() - x2)};
    }
    bool set_param(int param, Real value) { return set_by_group(motor, param, value); }
    bool get_param(int param, Real& value) const { return get_by_group(motor, param, value); }
    void state(StateStream& stream)
    {
        for (LimitMotor& m : motor) m.state(*world, stream);
    }
    void structure(StructureStream& stream) { structure_of_axes(stream, count, rel, axis_local); }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(LMotor);

void LMotor::describe(DifWriter& out) const
{
    out.integer("num", count);
    out.list("rel", {Real(rel[0]), Real(rel[1]), Real(rel[2])});
    for (int i = 0; i < 3; ++i) epode::describe(out, "axis", axis_local[i], i + 1);
    epode::describe(out, motor);
}

}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateLMotor(dWorldID w, dJointGroupID g) { return create_joint<LMotor>(w, g); }

void dJointSetLMotorNumAxes(dJointID id, int count)
{
    if (LMotor* j = checked<LMotor>(id)) j->count = count < 0 ? 0 : count > 3 ? 3 : count;
}

int dJointGetLMotorNumAxes(dJointID id)
{
    const LMotor* j = checked<LMotor>(id);
    return j ? j->count : 0;
}

void dJointSetLMotorAxis(dJointID id, int i, int rel, dReal x, dReal y, dReal z)
{
    LMotor* j = checked<LMotor>(id);
    Vec3 axis{x, y, z};
    if (!j || !demand(i >= 0 && i < 3 && rel >= 0 && rel <= 2, __func__)) return;
    if (demand(usable(axis) && normalize(axis), __func__)) j->set_axis(i, rel, axis);
}

void dJointGetLMotorAxis(dJointID id, int i, dVector3 result)
{
    const LMotor* j = checked<LMotor>(id);
    if (j && demand(i >= 0 && i < 3 && result, __func__)) store(result, j->axis_local[i]);
}

void dJointSetLMotorParam(dJointID id, int param, dReal value) { set_joint_param<LMotor>(id, param, value); }
dReal dJointGetLMotorParam(dJointID id, int param) { return get_joint_param<LMotor>(id, param); }

}  // extern "C"
