// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Builds ragdolls with the functions that a program has: whatever they make is in states, clones and files already.
// The bone is body 1 of its joint, so that angles are those of the bone against its parent.
#include <algorithm>

#include "assemblies/skeleton.h"
#include "base/float_environment.h"
#include "collide/types/registry.h"
#include "dynamics/world.h"
#include "math/rotation.h"
#include "ode/drives.h"
#include "ode/ode.h"

namespace epode {
namespace {

struct Frame {
    Vec3 position;
    Quat q;
    Vec3 point(const Real* p) const { return position + to_matrix(q) * load(p); }
    Vec3 direction(Vec3 v) const { return to_matrix(q) * v; }
};

void set_mass(dBodyID body, const dBone& bone)
{
    const dReal density = bone.density > 0 ? bone.density : dReal(1000);
    dMass mass;
    if (bone.shape == dBoneCapsule) dMassSetCapsule(&mass, density, 3, bone.size[0], bone.size[1]);
    if (bone.shape == dBoneBox) dMassSetBox(&mass, density, bone.size[0], bone.size[1], bone.size[2]);
    if (bone.shape == dBoneSphere) dMassSetSphere(&mass, density, bone.size[0]);
    if (bone.mass > 0) dMassAdjust(&mass, bone.mass);
    dBodySetMass(body, &mass);
}

dGeomID create_shape(dSpaceID space, const dBone& bone)
{
    if (bone.shape == dBoneCapsule) return dCreateCapsule(space, bone.size[0], bone.size[1]);
    if (bone.shape == dBoneBox) return dCreateBox(space, bone.size[0], bone.size[1], bone.size[2]);
    return dCreateSphere(space, bone.size[0]);
}

dBodyID create_bone(dWorldID world, dSpaceID space, const dBone& bone, const Frame& frame)
{
    const dBodyID body = dBodyCreate(world);
    if (!body) return nullptr;
    set_mass(body, bone);
    const dGeomID geom = create_shape(space, bone);
    if (!geom) {
        dBodyDestroy(body);
        return nullptr;
    }
    dGeomSetBody(geom, body);
    const Vec3 at = frame.point(bone.position);
    dQuaternion q;
    store_quat(q, frame.q * orientation_of(bone));
    dBodySetPosition(body, at.x, at.y, at.z);
    dBodySetQuaternion(body, q);
    return body;
}

// Stops of an axis, and its friction; `set` is the type's own function of parameters.
template <typename Set>
void set_limits(dJointID joint, int axis, Real low, Real high, Set set)
{
    if (!(low < high)) return;
    set(joint, dParamLoStop + dParamGroup * axis, low);
    set(joint, dParamHiStop + dParamGroup * axis, high);
}

bool set_friction(dJointID joint, int axes, Real friction)
{
    if (friction == 0) return true;
    dDrive drive{};
    drive.struct_size = sizeof drive;
    drive.friction = friction;
    for (int axis = 0; axis < axes; ++axis)
        if (!dJointSetDrive(joint, axis, &drive)) return false;
    return true;
}

bool make_hinge(dWorldID world, dBodyID body, dBodyID parent, const dBone& bone, const Frame& frame)
{
    const dJointID joint = dJointCreateHinge(world, nullptr);
    if (!joint) return false;
    const Vec3 at = frame.point(bone.anchor), t = frame.direction(axes_of(bone).twist);
    dJointAttach(joint, body, parent);
    dJointSetHingeAnchor(joint, at.x, at.y, at.z);
    dJointSetHingeAxis(joint, t.x, t.y, t.z);
    set_limits(joint, 0, bone.low[0], bone.high[0], dJointSetHingeParam);
    return set_friction(joint, 1, bone.friction);
}

// Axis 1 is fixed in the bone, axis 2 in the parent.
bool make_universal(dWorldID world, dBodyID body, dBodyID parent, const dBone& bone, const Frame& frame)
{
    const dJointID joint = dJointCreateUniversal(world, nullptr);
    if (!joint) return false;
    const Vec3 at = frame.point(bone.anchor);
    const BoneAxes axes = axes_of(bone);
    const Vec3 u = frame.direction(axes.across), s = frame.direction(axes.swing);
    dJointAttach(joint, body, parent);
    dJointSetUniversalAnchor(joint, at.x, at.y, at.z);
    dJointSetUniversalAxis1(joint, u.x, u.y, u.z);
    dJointSetUniversalAxis2(joint, s.x, s.y, s.z);
    set_limits(joint, 0, bone.low[1], bone.high[1], dJointSetUniversalParam);
    set_limits(joint, 1, bone.low[2], bone.high[2], dJointSetUniversalParam);
    return set_friction(joint, 2, bone.friction);
}

bool make_ball(dWorldID world, dBodyID body, dBodyID parent, const dBone& bone, const Frame& frame)
{
    const dJointID ball = dJointCreateBall(world, nullptr), motor = dJointCreateAMotor(world, nullptr);
    if (ball) dJointAttach(ball, body, parent);
    if (motor) dJointAttach(motor, body, parent);
    if (!ball || !motor) return false;
    const Vec3 at = frame.point(bone.anchor);
    const BoneAxes axes = axes_of(bone);
    const Vec3 t = frame.direction(axes.twist), s = frame.direction(axes.swing);
    dJointSetBallAnchor(ball, at.x, at.y, at.z);
    dJointSetAMotorMode(motor, dAMotorEuler);
    dJointSetAMotorAxis(motor, 0, 1, t.x, t.y, t.z);
    dJointSetAMotorAxis(motor, 2, 2, s.x, s.y, s.z);
    for (int axis = 0; axis < 3; ++axis)
        set_limits(motor, axis, bone.low[axis], bone.high[axis], dJointSetAMotorParam);
    return set_friction(motor, 3, bone.friction);
}

bool make_fixed(dWorldID world, dBodyID body, dBodyID parent)
{
    const dJointID joint = dJointCreateFixed(world, nullptr);
    if (!joint) return false;
    dJointAttach(joint, body, parent);
    dJointSetFixed(joint);
    return true;
}

bool connect(dWorldID world, dBodyID body, dBodyID parent, const dBone& bone, const Frame& frame)
{
    switch (bone.joint) {
        case dBoneHinge:
            return make_hinge(world, body, parent, bone, frame);
        case dBoneUniversal:
            return make_universal(world, body, parent, bone, frame);
        case dBoneBall:
            return make_ball(world, body, parent, bone, frame);
        default:
            return make_fixed(world, body, parent);
    }
}

// A body with its geoms and joints.
void destroy_bone(dBodyID body)
{
    while (dBodyGetNumJoints(body) > 0) dJointDestroy(dBodyGetJoint(body, 0));
    while (const dGeomID geom = dBodyGetFirstGeom(body)) dGeomDestroy(geom);
    dBodyDestroy(body);
}

bool build(dWorldID world, dSpaceID space, const dBone* bones, int count, const Frame& frame, dBodyID* made)
{
    for (int i = 0; i < count; ++i) {
        const dBone& bone = bones[i];
        made[i] = create_bone(world, space, bone, frame);
        const bool connected = made[i] && (i == 0 || connect(world, made[i], made[bone.parent], bone, frame));
        if (connected) continue;
        for (int k = made[i] ? i : i - 1; k >= 0; --k) destroy_bone(made[k]);
        return false;
    }
    return true;
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" int dRagdollCreate(dWorldID world_id, dSpaceID space, const dBone* bones, int count,
                              const dVector3 position, const dQuaternion orientation, dBodyID* bodies)
{
    const FloatEnvironment floats;
    World* const world = from_handle<World>(world_id);
    EPODE_USER(world, 0);
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world), 0);
    EPODE_PARENT_SPACE(space, 0);
    EPODE_USER(bones && bodies, 0);
    const char* const fault = fault_of_bones(bones, count);
    EPODE_USER_SAY(!fault, fault, 0);
    EPODE_USER(!position || usable(position, 3), 0);
    EPODE_USER(!orientation || usable(orientation, 4), 0);
    Frame frame{position ? load(position) : Vec3{}, {1, 0, 0, 0}};
    if (orientation) {
        frame.q = load_quat(orientation);
        EPODE_USER(normalize(frame.q), 0);
    }
    dBodyID made[dRagdollMaxBones];
    EPODE_USER_SAY(build(world_id, space, bones, count, frame, made), kOutOfMemory, 0);
    std::copy_n(made, count, bodies);
    return count;
}
