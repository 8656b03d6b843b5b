// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Double ball: a rod with a ball joint at each end keeps two points at a distance.
//   one row, unbounded: see rod.h
// Not a ball joint with a soft row: the length is a number of the joint and may be changed while it works.
#include "joints/access.h"
#include "joints/types/rod.h"

namespace epode {

struct DBall : LastingJoint {
    static constexpr int kMaxRows = 1;
    static constexpr const char* kDifName = "double_ball_joint";
    DBall(const JointType& t, World& w) : LastingJoint(t, w), rod(w) {}

    Rod rod;

    void emit(RowWriter& out) const { rod.lock(*this, out); }
    void bodies_changed() { rod.measure(*this); }
    OwnSoftness* own_softness() { return &rod.softness; }
    bool set_param(int param, Real value) { return rod.softness.set(param, value); }
    bool get_param(int param, Real& value) const { return rod.softness.get(param, value); }
    void state(StateStream& stream) { rod.softness.state(*world, stream); }
    void shift(Vec3 by) { rod.shift(*this, by); }
    void structure(StructureStream& stream) { rod.structure(stream); }
    void describe(DifWriter& out) const { rod.describe(out); }
};

JOINT_DEFINE(DBall);

namespace {

void set_end(dJointID id, int i, Vec3 point, const char* caller)
{
    DBall* j = checked<DBall>(id, caller);
    if (j && demand(usable(point), caller)) j->rod.set_user_end(*j, i, point);
}

void get_end(dJointID id, int i, Real* result, const char* caller)
{
    const DBall* j = checked<DBall>(id, caller);
    if (j && demand(result, caller)) store(result, j->rod.end.of_user(*j, i));
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateDBall(dWorldID w, dJointGroupID g) { return create_joint<DBall>(w, g); }

void dJointSetDBallAnchor1(dJointID id, dReal x, dReal y, dReal z) { set_end(id, 0, {x, y, z}, __func__); }
void dJointSetDBallAnchor2(dJointID id, dReal x, dReal y, dReal z) { set_end(id, 1, {x, y, z}, __func__); }
void dJointGetDBallAnchor1(dJointID id, dVector3 result) { get_end(id, 0, result, __func__); }
void dJointGetDBallAnchor2(dJointID id, dVector3 result) { get_end(id, 1, result, __func__); }

void dJointSetDBallDistance(dJointID id, dReal distance)
{
    DBall* j = joint_for_number<DBall>(id, distance);
    if (j && demand(distance >= 0, __func__)) j->rod.length = distance;
}

dReal dJointGetDBallDistance(dJointID id)
{
    const DBall* j = checked<DBall>(id);
    return j ? j->rod.length : 0;
}

void dJointSetDBallParam(dJointID id, int param, dReal value) { set_joint_param<DBall>(id, param, value); }
dReal dJointGetDBallParam(dJointID id, int param) { return get_joint_param<DBall>(id, param); }

}  // extern "C"
