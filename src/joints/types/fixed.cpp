// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Fixed: body 1 keeps its pose in the frame of body 2.
//   C(x) = x2 - x1 + R1 o = 0           o = R1^T (x1 - x2) at set time; without body 2: o - x1,
//                                      o in the world
//          2 vec(q1^-1 q2 q0^-1) = 0   q0 = q1^-1 q2 at set time
//   J    = [ e, o x e, -e, 0 ],  [ 0, e, 0, -e ],   e = x, y, z of the world
// Attaching does not take the pose over, dJointSetFixed does; before that o and q0 are zero, and clients see
// it (spec'd behaviour of ODE). The joint's own ERP and CFM belong to the linear rows only, as there.
#include "joints/access.h"

namespace epode {

struct Fixed : LastingJoint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "fixed_joint";
    Fixed(const JointType& t, World& w) : LastingJoint(t, w), softness(w) {}

    Vec3 offset;
    Quat zero{0, 0, 0, 0};
    OwnSoftness softness;

    void take_pose()
    {
        const Vec3 x1 = body1()->position();
        offset = body2() ? direction_to_local(body1(), x1 - body2()->position()) : x1;
        zero = relative_orientation(*this);
    }

    void emit(RowWriter& out) const
    {
        const Vec3 x1 = body1()->position();
        const Vec3 o = body2() ? direction_to_world(body1(), offset) : Vec3{};
        const Vec3 error = body2() ? body2()->position() - x1 + o : offset - x1;
        const Vec3 r1 = body2() && !world->acts_as_ode() ? body2()->position() - x1 : -o;
        out.point_at(r1, {}, RowForm::kPoint);
        for (int i = 0; i < 3; ++i) {
            Vec3 e;
            e.set(i, 1);
            softness.apply_to(out, out.row(point_jacobian(*this, e, r1, Vec3{}), error[i]));
        }
        lock_orientation(*this, out, zero);
    }

    OwnSoftness* own_softness() { return &softness; }
    bool set_param(int param, Real value) { return softness.set(param, value); }
    bool get_param(int param, Real& value) const { return softness.get(param, value); }
    void state(StateStream& stream) { softness.state(*world, stream); }
    void shift(Vec3 by)
    {
        if (!body2()) offset += by;
    }
    void structure(StructureStream& stream) { stream.vector(offset), stream.quaternion(zero); }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(Fixed);

void Fixed::describe(DifWriter& out) const
{
    epode::describe(out, "qrel", zero);
    epode::describe(out, "offset", offset);
}

}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateFixed(dWorldID w, dJointGroupID g) { return create_joint<Fixed>(w, g); }

void dJointSetFixed(dJointID id)
{
    if (Fixed* j = attached_joint<Fixed>(id)) j->take_pose();
}

void dJointSetFixedParam(dJointID id, int param, dReal value) { set_joint_param<Fixed>(id, param, value); }
dReal dJointGetFixedParam(dJointID id, int param) { return get_joint_param<Fixed>(id, param); }

}  // extern "C"
