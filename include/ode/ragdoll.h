/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Ragdolls: figures of bodies, geoms and joints from a list of bones, and motors that hold a pose. Included
 * by ode/ext.h. */
#ifndef _ODE_RAGDOLL_H_
#define _ODE_RAGDOLL_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter ragdoll Ragdolls

    A list of bones says how a figure is built; dRagdollCreate makes a body with a geom of each, and joints
    between them. They are bodies, geoms and joints like any others: states, histories, clones and files have
    them, and the program may change, add or destroy what it likes. Bones with a common joint do not collide with
    each other where the world manages contacts; all others do. The list belongs to the program, and all figures
    built from it share it. docs/guide/howto/ragdolls.md explains.

    A pose is an orientation of each bone against its parent, as animations have them; that of bone 0 is its
    orientation in the world. Angles of a bone turn it against its parent by the right hand, and are zero in
    the pose in which the list has it.

    Arguments:
    - bones: the list, count of them, each parent before its children.
    - count: how many bones, 1 ... dRagdollMaxBones.
    - bodies: those that dRagdollCreate has made, in the order of the bones.
    - pose: count orientations.

    Refused: null pointers; numbers that are not finite; bones with a field outside what it says; a count
    outside 1 ... dRagdollMaxBones; [dRagdollCreate] a world that is 0 or destroyed, a space that is
    destroyed; [dRagdollSetPose, dRagdollGetPose, dRagdollFollow, dRagdollGetGap] a body that is 0 or
    destroyed, bodies of several worlds; [dRagdollSetPose, dRagdollFollow] a pose with a quaternion of
    length 0; [dRagdollFollow] a pose that no usable velocity reaches in h; [dRagdollCreate,
    dRagdollSetPose, dRagdollFollow] a call during a step; what each function names. Nothing changes then,
    and the answer is 0. */

/** How many bones a ragdoll may have. */
enum { dRagdollMaxBones = 128 };

/** The shape of a bone. */
typedef enum {
    dBoneCapsule, /**< along the bone's z: radius, length of the cylinder */
    dBoneBox,     /**< three sides */
    dBoneSphere   /**< radius */
} dBoneShape;

/** What connects a bone with its parent. */
typedef enum {
    dBoneHinge,     /**< turns about its axis */
    dBoneUniversal, /**< swings about two axes and does not twist about its own */
    dBoneBall,      /**< swings and twists: a ball joint, and an angular motor that has limits and drives */
    dBoneFixed      /**< does not turn */
} dBoneJoint;

/** A bone, and the joint with its parent. Elements of arrays, such as this, have no struct_size. Zeros are
    a good start: what is 0 is not there, but for what a field says. Places and directions are in one frame
    of the whole figure, in any pose within the limits. */
typedef struct dBone {
    int parent;              /**< number of an earlier bone; -1 for bone 0, which has none */
    int shape;               /**< a dBoneShape */
    dVector3 size;           /**< as dBoneShape says, m, above 0 */
    dReal mass;              /**< kg, 0 or more; 0: as density says */
    dReal density;           /**< kg/m^3, 0 or more; 0: 1000 */
    dVector3 position;       /**< of the centre, m */
    dQuaternion orientation; /**< of the shape; zeros: none */
    int joint;               /**< a dBoneJoint */
    dVector3 anchor;         /**< of the joint, m */
    dVector3 axis;           /**< not 0, of any length: the hinge's, or that of the twist, along the bone */
    dVector3
        swing;    /**< dBoneUniversal, dBoneBall: the first swing's, fixed in the parent; not along axis. What
        is along axis is taken away. The second is swing x axis, at right angles to both */
    dReal low[3]; /**< rad, of twist, second and first swing; a hinge has the first alone. -pi ... pi, of
        the second swing -1.5 ... 1.5 */
    dReal high[3];   /**< likewise; where low is not below high, there is no limit */
    dReal stiffness; /**< of the motors that hold a pose, N m/rad, 0 or more */
    dReal damping;   /**< likewise, N m s/rad */
    dReal strength;  /**< the greatest torque of each, N m, 0 or more; 0: no limit */
    dReal friction;  /**< dry friction of each axis, N m, 0 or more */
} dBone;

/** Write to bones, which has capacity of them, a human of this height and mass that stands, facing x, left y,
    up z, the soles at z = 0: 16 bones, in proportions and masses of Drillis and Contini and of Dempster.
    docs/guide/howto/ragdolls.md has them. Returns 16. Refused: a height outside 0.1 ... 100 m, a mass outside
    0.001 ... 1e6 kg, a capacity below 16. [ours] */
ODE_API int dBonesMakeHuman(dBone* bones, int capacity, dReal height, dReal mass);

/** Build a figure of the bones in the world, its geoms in space, which may be 0, with the list's frame at
    position (m) and orientation, either of which may be 0: none. Write the bodies of the bones to bodies,
    which has as many places. Without motors: it is limp. Returns count. [ours] */
ODE_API int dRagdollCreate(dWorldID world, dSpaceID space, const dBone* bones, int count,
                           const dVector3 position, const dQuaternion orientation, dBodyID* bodies);

/** - dRagdollSetPose: Let motors pull the figure to a pose, where it can with their stiffness, damping and
      strength, times strength, 0 or more, each: drives (dJointSetDrive), implicit, stable at any step. 0: limp.
      What the pose says of bone 0 does not count. A change wakes the figure. Returns how many joints have
      motors.
    - dRagdollGetPose: Write the present pose to pose. Returns count. [ours] */
ODE_API int dRagdollSetPose(const dBone* bones, const dBodyID* bodies, int count, const dQuaternion* pose,
                            dReal strength);
ODE_API int dRagdollGetPose(const dBone* bones, const dBodyID* bodies, int count, dQuaternion* pose);

/** Follow an animation: give the bodies velocities that bring them in the coming step of h seconds, above 0
    and at most 1, to the pose with bone 0 at position (m). weight, 0 ... 1, is the share of these velocities, the
    rest is what they have: 1 follows, 0 does nothing; between, a game lets go. The share of weight of gravity is
    taken away. Kinematic bodies follow wholly. Call it before each step. Returns how many bodies follow.
    [ours] */
ODE_API int dRagdollFollow(const dBone* bones, const dBodyID* bodies, int count, const dVector3 position,
                           const dQuaternion* pose, dReal weight, dReal h);

/** Returns the largest gap of a joint of the figure, m: how far the two sides of an anchor are apart. [ours] */
ODE_API dReal dRagdollGetGap(const dBone* bones, const dBodyID* bodies, int count);

#ifdef __cplusplus
}
#endif

#endif
