// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A list of bones (ode/ragdoll.h) as numbers: what is wrong with it, the frames of its joints, and the angles of a
// turn. With the first swing's axis s, the twist's t at right angles to it and u = s x t, all as they are in the
// list's pose, a bone that is turned by D against its parent has
//   D = exp(a s) exp(b u) exp(c t)
//   D t   = cos b cos a t + cos b sin a u - sin b s      gives a and b
//   D^T s = cos b cos c s + cos b sin c u - sin b t      gives c
// which are the Euler angles of an AMotor whose body 1 is the bone: axis 0 is t, axis 1 u, axis 2 s.
#pragma once

#include "math/pose.h"
#include "ode/ragdoll.h"

namespace epode {

// Null, or what is wrong with the list.
const char* fault_of_bones(const dBone* bones, int count);

struct BoneAxes {
    Vec3 twist, across, swing;  // t, u, s: unit, in the list's frame
};
BoneAxes axes_of(const dBone& bone);

// The bone's orientation and place in the list's frame.
Quat orientation_of(const dBone& bone);
Vec3 to_bone(const dBone& bone, Vec3 in_list);    // a point of the list's frame, seen from the bone
Vec3 from_list(const dBone& bone, Vec3 in_list);  // a direction likewise

// c, b, a of a bone that is turned so against its parent; of a hinge and a universal joint the nearest such turn.
struct BoneAngles {
    Real twist, across, swing;
};
BoneAngles angles_of(const dBone* bones, int bone, Quat against_parent);

// The vector of a turn: along its axis, as long as its angle, at most pi.
Vec3 rotation_vector(Quat q);

}  // namespace epode
