// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// NAME: a point of body 1 and a point of body 2 coincide.
//   C(x) = x2 + R2 s2 - x1 - R1 s1 = 0                        three rows, unbounded
//   J    = [ e, r1 x e, -e, -(r2 x e) ],  e = x, y, z of the world, ri = Ri si
#include "joints/access.h"

namespace epode {

struct NAME : LastingJoint {
    static constexpr int kMaxRows = 3;
    static constexpr const char* kDifName = "FILE_joint";
    NAME(const JointType& t, World& w) : LastingJoint(t, w), softness(w) {}

    AnchorPair anchor;
    OwnSoftness softness;

    // As many rows at an inner pose of a step as at its first (docs/architecture.md, A joint type).
    void emit(RowWriter& out) const { lock_point(*this, out, anchor, &softness); }
    void bodies_changed() { anchor.reattach(*this); }
    bool set_param(int param, Real value) { return softness.set(param, value); }
    bool get_param(int param, Real& value) const { return softness.get(param, value); }
    void state(StateStream& stream) { softness.state(*world, stream); }    // what steps and programs change
    void structure(StructureStream& stream) { anchor.structure(stream); }  // the rest, in clones and files
    void describe(DifWriter& out) const { epode::describe(out, anchor); }
};

JOINT_DEFINE(NAME);

}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateNAME(dWorldID w, dJointGroupID g) { return create_joint<NAME>(w, g); }

void dJointSetNAMEAnchor(dJointID id, dReal x, dReal y, dReal z)
{
    if (NAME* j = joint_for_point<NAME>(id, {x, y, z})) j->anchor.set(*j, {x, y, z});
}

void dJointGetNAMEAnchor(dJointID id, dVector3 result)
{
    if (const NAME* j = joint_for_result<NAME>(id, result)) store(result, j->anchor.of_user(*j, 0));
}

void dJointSetNAMEParam(dJointID id, int param, dReal value) { set_joint_param<NAME>(id, param, value); }
dReal dJointGetNAMEParam(dJointID id, int param) { return get_joint_param<NAME>(id, param); }

}  // extern "C"
