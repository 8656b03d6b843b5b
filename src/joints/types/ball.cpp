// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ball and socket: a point of body 1 and a point of body 2 coincide.
//   C(x) = x2 + R2 s2 - x1 - R1 s1 = 0                        three rows, unbounded
//   J    = [ e, r1 x e, -e, -(r2 x e) ],  e = x, y, z of the world, ri = Ri si
// World axes rather than axes of a body: the rows need no frame and the error is the plain difference.
#include "joints/access.h"

namespace epode {

struct Ball : LastingJoint {
    static constexpr int kMaxRows = 3;
    static constexpr const char* kDifName = "ball_joint";
    Ball(const JointType& t, World& w) : LastingJoint(t, w), softness(w) {}

    AnchorPair anchor;
    OwnSoftness softness;

    void emit(RowWriter& out) const { lock_point(*this, out, anchor, &softness); }
    void bodies_changed() { anchor.reattach(*this); }
    OwnSoftness* own_softness() { return &softness; }
    bool set_param(int param, Real value) { return softness.set(param, value); }
    bool get_param(int param, Real& value) const { return softness.get(param, value); }
    void state(StateStream& stream) { softness.state(*world, stream); }
    void shift(Vec3 by) { anchor.shift(*this, by); }
    void structure(StructureStream& stream) { anchor.structure(stream); }
    void describe(DifWriter& out) const { epode::describe(out, anchor); }
};

JOINT_DEFINE(Ball);

}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateBall(dWorldID w, dJointGroupID g) { return create_joint<Ball>(w, g); }

void dJointSetBallAnchor(dJointID id, dReal x, dReal y, dReal z)
{
    if (Ball* j = joint_for_point<Ball>(id, {x, y, z})) j->anchor.set(*j, {x, y, z});
}

// Raw numbers for the second body (or the world), as ODE has it.
void dJointSetBallAnchor2(dJointID id, dReal x, dReal y, dReal z)
{
    Ball* j = checked<Ball>(id);
    if (j && demand(usable(Vec3{x, y, z}), __func__)) j->anchor.local[1] = {x, y, z};
}

void dJointGetBallAnchor(dJointID id, dVector3 result)
{
    if (const Ball* j = joint_for_result<Ball>(id, result)) store(result, j->anchor.of_user(*j, 0));
}

void dJointGetBallAnchor2(dJointID id, dVector3 result)
{
    const Ball* j = checked<Ball>(id);
    if (j && demand(result, __func__)) store(result, j->anchor.of_user(*j, 1));
}

void dJointSetBallParam(dJointID id, int param, dReal value) { set_joint_param<Ball>(id, param, value); }
dReal dJointGetBallParam(dJointID id, int param) { return get_joint_param<Ball>(id, param); }

}  // extern "C"
