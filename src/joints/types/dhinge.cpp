// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Double hinge: a bar with a hinge at each end, both about one direction a.
//   a rod between the anchors: see rod.h
//   (a1 x a2).p = 0,  (a1 x a2).q = 0       J = [ 0, d, 0, -d ],  d = p, q perpendicular to a1
//   -a1.g = 0                               J = [ a1, c, -a1, c ],  c = 1/2 (x2 - x1) x a1;  g of the rod
// Softness of its own is the rod's; the other rows take its ERP and the world's CFM, as in ODE. While no axis
// has been given, which a new attachment does not do, only the rod acts: ODE then divides by the length of a
// zero axis.
#include "joints/access.h"
#include "joints/types/rod.h"

namespace epode {

struct DHinge : LastingJoint {
    static constexpr int kMaxRows = 4;
    static constexpr const char* kDifName = "double_hinge_joint";
    DHinge(const JointType& t, World& w) : LastingJoint(t, w), rod(w) {}

    Rod rod;
    AxisPair axis;  // zero: none yet

    void emit(RowWriter& out) const;
    void take_erp(Row& row) const { row.erp = rod.softness.erp, row.soft = rod.softness.chosen; }
    void bodies_changed() { rod.measure(*this); }
    OwnSoftness* own_softness() { return &rod.softness; }
    bool set_param(int param, Real value) { return rod.softness.set(param, value); }
    bool get_param(int param, Real& value) const { return rod.softness.get(param, value); }
    void state(StateStream& stream) { rod.softness.state(*world, stream); }
    void shift(Vec3 by) { rod.shift(*this, by); }
    void structure(StructureStream& stream) { rod.structure(stream), axis.structure(stream); }
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(DHinge);

void DHinge::describe(DifWriter& out) const
{
    rod.describe(out);
    epode::describe(out, axis);
}

void DHinge::emit(RowWriter& out) const
{
    rod.lock(*this, out);
    const Vec3 a1 = axis.world(*this, 0), u = cross(a1, axis.world(*this, 1));
    if (!(length2(a1) > 0)) return;
    Vec3 p, q;
    plane_space(a1, p, q);
    take_erp(out.row(angular_jacobian(*this, p), dot(u, p)));
    take_erp(out.row(angular_jacobian(*this, q), dot(u, q)));
    const Vec3 gap = rod.end.world(*this, 0) - rod.end.world(*this, 1);
    take_erp(out.row(sliding_jacobian(*this, a1), -dot(a1, gap)));
}

namespace {

void set_end(dJointID id, int i, Vec3 point, const char* caller)
{
    DHinge* j = checked<DHinge>(id, caller);
    if (j && demand(usable(point), caller)) j->rod.set_user_end(*j, i, point);
}

void get_end(dJointID id, int i, Real* result, const char* caller)
{
    const DHinge* j = checked<DHinge>(id, caller);
    if (j && demand(result, caller)) store(result, j->rod.end.of_user(*j, i));
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateDHinge(dWorldID w, dJointGroupID g) { return create_joint<DHinge>(w, g); }

void dJointSetDHingeAxis(dJointID id, dReal x, dReal y, dReal z)
{
    Vec3 axis{x, y, z};
    if (DHinge* j = joint_for_axis<DHinge>(id, axis)) j->axis.set(*j, axis);
}

void dJointGetDHingeAxis(dJointID id, dVector3 result)
{
    if (const DHinge* j = joint_for_result<DHinge>(id, result)) store(result, j->axis.world(*j, 0));
}

void dJointSetDHingeAnchor1(dJointID id, dReal x, dReal y, dReal z) { set_end(id, 0, {x, y, z}, __func__); }
void dJointSetDHingeAnchor2(dJointID id, dReal x, dReal y, dReal z) { set_end(id, 1, {x, y, z}, __func__); }
void dJointGetDHingeAnchor1(dJointID id, dVector3 result) { get_end(id, 0, result, __func__); }
void dJointGetDHingeAnchor2(dJointID id, dVector3 result) { get_end(id, 1, result, __func__); }

dReal dJointGetDHingeDistance(dJointID id)
{
    const DHinge* j = checked<DHinge>(id);
    return j ? j->rod.length : 0;
}

void dJointSetDHingeParam(dJointID id, int param, dReal value) { set_joint_param<DHinge>(id, param, value); }
dReal dJointGetDHingeParam(dJointID id, int param) { return get_joint_param<DHinge>(id, param); }

}  // extern "C"
