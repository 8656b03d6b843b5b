// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Poses of ragdolls. A joint is found by its bodies: the oldest that has the bone as body 1 and its parent as body 2.
#include <algorithm>

#include "assemblies/skeleton.h"
#include "base/float_environment.h"
#include "collide/types/registry.h"
#include "dynamics/body.h"
#include "dynamics/world.h"
#include "math/rotation.h"
#include "ode/drives.h"
#include "ode/impulses.h"
#include "ode/ode.h"

namespace epode {
namespace {

constexpr const char* kWrongBodies = "Bad argument(s)";

// Null: all live, in one world that is not busy, unless only read.
const char* fault_of_bodies(const dBodyID* bodies, int count, bool reading)
{
    World* world = nullptr;
    for (int i = 0; i < count; ++i) {
        Body* const body = from_handle<Body>(bodies[i]);
        if (!body) return kWrongBodies;
        if (world && body->world != world) return "bodies of several worlds";
        world = body->world;
    }
    return !reading && is_busy(*world) ? busy_text(*world) : nullptr;
}

const char* fault_of_pose(const dQuaternion* pose, int count)
{
    for (int i = 0; i < count; ++i) {
        Quat q = load_quat(pose[i]);
        if (!usable(pose[i], 4) || !normalize(q))
            return "orientation of a pose (accepted: of a length above 0)";
    }
    return nullptr;
}

dJointType type_of(const dBone& bone)
{
    switch (bone.joint) {
        case dBoneHinge:
            return dJointTypeHinge;
        case dBoneUniversal:
            return dJointTypeUniversal;
        case dBoneBall:
            return dJointTypeBall;
        default:
            return dJointTypeFixed;
    }
}

dJointID joint_of(dBodyID bone, dBodyID parent, dJointType type)
{
    for (int i = dBodyGetNumJoints(bone) - 1; i >= 0; --i) {
        const dJointID joint = dBodyGetJoint(bone, i);
        if (dJointGetType(joint) == type && dJointGetBody(joint, 0) == bone &&
            dJointGetBody(joint, 1) == parent)
            return joint;
    }
    return nullptr;
}

// The joint with the bone's angles.
dJointID driven_joint(const dBone& bone, dBodyID body, dBodyID parent)
{
    if (bone.joint == dBoneFixed) return nullptr;
    return joint_of(body, parent, bone.joint == dBoneBall ? dJointTypeAMotor : type_of(bone));
}

bool drive_to(dJointID joint, int axis, Real target, const dBone& bone, Real strength)
{
    dDrive drive{};
    drive.struct_size = sizeof drive;
    drive.friction = bone.friction;
    drive.stiffness = strength * bone.stiffness;
    drive.damping = strength * bone.damping;
    drive.force_limit = strength * bone.strength;
    drive.target = strength > 0 ? target : 0;
    return dJointSetDrive(joint, axis, &drive);
}

// Targets beyond a limit are at the limit.
Real in_limits(const dBone& bone, int i, Real angle)
{
    return bone.low[i] < bone.high[i] ? std::clamp(angle, bone.low[i], bone.high[i]) : angle;
}

bool drive_bone(dJointID joint, const dBone& bone, const BoneAngles& to, Real strength)
{
    const Real twist = in_limits(bone, 0, to.twist), across = in_limits(bone, 1, to.across),
               swing = in_limits(bone, 2, to.swing);
    if (bone.joint == dBoneHinge) return drive_to(joint, 0, twist, bone, strength);
    if (bone.joint == dBoneUniversal)
        return drive_to(joint, 0, across, bone, strength) && drive_to(joint, 1, swing, bone, strength);
    return drive_to(joint, 0, twist, bone, strength) && drive_to(joint, 1, across, bone, strength) &&
           drive_to(joint, 2, swing, bone, strength);
}

struct Placed {
    Vec3 p;
    Quat q;
};

// Where the pose puts the bone, whose parent it has placed already.
Placed place_bone(const dBone* bones, int i, const Placed& parent, Quat against_parent)
{
    const dBone& bone = bones[i];
    const Vec3 anchor = load(bone.anchor);
    Quat q = parent.q * against_parent;
    (void)normalize(q);
    const Vec3 at = parent.p + to_matrix(parent.q) * to_bone(bones[bone.parent], anchor);
    return {at - to_matrix(q) * to_bone(bone, anchor), q};
}

struct Velocities {
    Vec3 linear, angular;
};

// The share of the kinematic is 1.
Real share_of(dBodyID id, Real weight) { return dBodyIsKinematic(id) ? 1 : weight; }

Velocities way_to(dBodyID id, const Placed& to, Real weight, Real h)
{
    const Real w = share_of(id, weight);
    const Quat now = load_quat(dBodyGetQuaternion(id));
    const Vec3 v = (to.p - load(dBodyGetPosition(id))) / h, turn = rotation_vector(to.q * conjugate(now)) / h;
    return {(1 - w) * load(dBodyGetLinearVel(id)) + w * v, (1 - w) * load(dBodyGetAngularVel(id)) + w * turn};
}

void follow(dBodyID id, const Velocities& way, Real weight)
{
    const bool kinematic = dBodyIsKinematic(id);
    const Real w = share_of(id, weight);
    dVector3 lin, ang, gravity;
    store(lin, way.linear), store(ang, way.angular);
    dBodySetVelocities(id, lin, ang, 1);
    if (kinematic || !dBodyGetGravityMode(id)) return;
    dMass mass;
    dBodyGetMass(id, &mass);
    dWorldGetGravity(dBodyGetWorld(id), gravity);
    const Vec3 lift = -w * mass.mass * load(gravity);
    dBodyAddForce(id, lift.x, lift.y, lift.z);
}

Vec3 anchor_of(dBodyID body, const dBone& bone, const dBone& joint)
{
    return load(dBodyGetPosition(body)) +
           to_matrix(load_quat(dBodyGetQuaternion(body))) * to_bone(bone, load(joint.anchor));
}

}  // namespace
}  // namespace epode

#define EPODE_FIGURE(bones, bodies, count, reading)                           \
    EPODE_USER((bones) && (bodies), 0);                                       \
    {                                                                         \
        const char* fault = ::epode::fault_of_bones(bones, count);            \
        if (!fault) fault = ::epode::fault_of_bodies(bodies, count, reading); \
        EPODE_USER_SAY(!fault, fault, 0);                                     \
    }

using namespace epode;

extern "C" int dRagdollSetPose(const dBone* bones, const dBodyID* bodies, int count, const dQuaternion* pose,
                               dReal strength)
{
    const FloatEnvironment floats;
    EPODE_FIGURE(bones, bodies, count, false);
    EPODE_USER(pose, 0);
    const char* const fault = fault_of_pose(pose, count);
    EPODE_USER_SAY(!fault, fault, 0);
    EPODE_USER_SAY(usable(strength) && strength >= 0 && strength <= Real(1e6),
                   "strength (accepted: 0 ... 1e6)", 0);
    int driven = 0;
    for (int i = 1; i < count; ++i) {
        const dJointID joint = driven_joint(bones[i], bodies[i], bodies[bones[i].parent]);
        if (!joint) continue;
        Quat q = load_quat(pose[i]);
        (void)normalize(q);
        EPODE_USER_SAY(drive_bone(joint, bones[i], angles_of(bones, i, q), strength), kOutOfMemory, 0);
        driven += strength > 0;
    }
    return driven;
}

extern "C" int dRagdollGetPose(const dBone* bones, const dBodyID* bodies, int count, dQuaternion* pose)
{
    const FloatEnvironment floats;
    EPODE_FIGURE(bones, bodies, count, true);
    EPODE_USER(pose, 0);
    for (int i = 0; i < count; ++i) {
        const Quat q = load_quat(dBodyGetQuaternion(bodies[i]));
        const Quat base = i == 0 ? Quat{1, 0, 0, 0} : load_quat(dBodyGetQuaternion(bodies[bones[i].parent]));
        store_quat(pose[i], conjugate(base) * q);
    }
    return count;
}

extern "C" int dRagdollFollow(const dBone* bones, const dBodyID* bodies, int count, const dVector3 position,
                              const dQuaternion* pose, dReal weight, dReal h)
{
    const FloatEnvironment floats;
    EPODE_FIGURE(bones, bodies, count, false);
    EPODE_USER(position && usable(position, 3) && pose, 0);
    const char* const fault = fault_of_pose(pose, count);
    EPODE_USER_SAY(!fault, fault, 0);
    EPODE_USER_SAY(usable(weight) && weight >= 0 && weight <= 1, "weight (accepted: 0 ... 1)", 0);
    EPODE_USER_SAY(usable(h) && h > 0 && h <= 1, "h (accepted: above 0, at most 1 s)", 0);
    Placed placed[dRagdollMaxBones];
    Velocities moves[dRagdollMaxBones];
    for (int i = 0; i < count; ++i) {
        Quat q = load_quat(pose[i]);
        (void)normalize(q);
        placed[i] = i == 0 ? Placed{load(position), q} : place_bone(bones, i, placed[bones[i].parent], q);
        moves[i] = way_to(bodies[i], placed[i], weight, h);
        EPODE_USER_SAY(usable(&moves[i].linear.x, 3) && usable(&moves[i].angular.x, 3),
                       "the pose is too far away for a step of h", 0);
    }
    int following = 0;
    for (int i = 0; i < count; ++i) {
        if (share_of(bodies[i], weight) == 0) continue;
        follow(bodies[i], moves[i], weight);
        ++following;
    }
    return following;
}

extern "C" dReal dRagdollGetGap(const dBone* bones, const dBodyID* bodies, int count)
{
    const FloatEnvironment floats;
    EPODE_FIGURE(bones, bodies, count, true);
    Real gap = 0;
    for (int i = 1; i < count; ++i) {
        const int parent = bones[i].parent;
        gap = std::max(gap, length(anchor_of(bodies[i], bones[i], bones[i]) -
                                   anchor_of(bodies[parent], bones[parent], bones[i])));
    }
    return gap;
}
