// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "assemblies/skeleton.h"

#include <cmath>

#include "base/check.h"
#include "math/rotation.h"
#include "math/trig.h"

namespace epode {
namespace {

constexpr Real kWidestSwing = Real(1.5);  // Euler angles are singular at a right angle

bool is_number_or_more(Real x) { return usable(x) && x >= 0; }

bool has_size(const dBone& bone)
{
    const int counts[] = {2, 3, 1};
    const int numbers = counts[bone.shape];
    for (int i = 0; i < numbers; ++i)
        if (!(usable(bone.size[i]) && bone.size[i] > 0)) return false;
    return true;
}

bool has_direction(const Real* p)
{
    Vec3 v = load(p);
    return usable(p, 3) && normalize(v);
}

bool has_axes(const dBone& bone)
{
    if (bone.joint == dBoneFixed) return true;
    if (!has_direction(bone.axis)) return false;
    if (bone.joint == dBoneHinge) return true;
    if (!has_direction(bone.swing)) return false;
    const Vec3 t = normalized_or(load(bone.axis), {}), s = normalized_or(load(bone.swing), {});
    return length(cross(s, t)) > Real(1e-3);
}

bool has_limits(const dBone& bone)
{
    for (int i = 0; i < 3; ++i) {
        const Real widest = i == 1 ? kWidestSwing : Real(3.1416);
        for (const Real x : {bone.low[i], bone.high[i]})
            if (!(usable(x) && within(x, widest))) return false;
    }
    return true;
}

const char* fault_of_bone(const dBone& bone, int i)
{
    if (i == 0 ? bone.parent != -1 : bone.parent < 0 || bone.parent >= i)
        return "parent of a bone (accepted: an earlier bone; -1 for bone 0)";
    if (bone.shape < dBoneCapsule || bone.shape > dBoneSphere) return "no such shape of a bone";
    if (!has_size(bone)) return "size of a bone (accepted: above 0)";
    if (!is_number_or_more(bone.mass) || !is_number_or_more(bone.density))
        return "mass or density of a bone (accepted: 0 or more)";
    Quat q = load_quat(bone.orientation);
    const bool turned = !(q == Quat{0, 0, 0, 0});
    if (!usable(bone.position, 3) || !usable(bone.orientation, 4) || (turned && !normalize(q)))
        return "position or orientation of a bone";
    if (i == 0) return nullptr;
    if (bone.joint < dBoneHinge || bone.joint > dBoneFixed) return "no such joint of a bone";
    if (!usable(bone.anchor, 3) || !has_axes(bone)) return "anchor, axis or swing of a bone";
    if (!has_limits(bone)) return "low or high of a bone (accepted: -pi ... pi, second swing -1.5 ... 1.5)";
    for (const Real x : {bone.stiffness, bone.damping, bone.strength, bone.friction})
        if (!is_number_or_more(x)) return "stiffness, damping, strength or friction (accepted: 0 or more)";
    return nullptr;
}

Real about_hinge(Quat turn, Vec3 axis)
{
    const Real angle = 2 * atan2(dot(turn.vec(), axis), turn.w);
    return angle > kPi ? angle - 2 * kPi : angle < -kPi ? angle + 2 * kPi : angle;
}

}  // namespace

const char* fault_of_bones(const dBone* bones, int count)
{
    if (count < 1 || count > dRagdollMaxBones) return "count of bones (accepted: 1 ... 128)";
    for (int i = 0; i < count; ++i)
        if (const char* fault = fault_of_bone(bones[i], i)) return fault;
    return nullptr;
}

BoneAxes axes_of(const dBone& bone)
{
    const Vec3 t = normalized_or(load(bone.axis), {0, 0, 1});
    const Vec3 s = load(bone.swing);
    const Vec3 square = normalized_or(s - dot(s, t) * t, {1, 0, 0});
    return {t, cross(square, t), square};
}

Quat orientation_of(const dBone& bone)
{
    Quat q = load_quat(bone.orientation);
    return normalize(q) ? q : Quat{1, 0, 0, 0};
}

Vec3 from_list(const dBone& bone, Vec3 in_list)
{
    return transposed_times(to_matrix(orientation_of(bone)), in_list);
}

Vec3 to_bone(const dBone& bone, Vec3 in_list) { return from_list(bone, in_list - load(bone.position)); }

BoneAngles angles_of(const dBone* bones, int i, Quat against_parent)
{
    const dBone& bone = bones[i];
    // In the list's frame: the parent stands there as the list says, and the bone has turned by D.
    const Quat D = orientation_of(bones[bone.parent]) * against_parent * conjugate(orientation_of(bone));
    const BoneAxes axes = axes_of(bone);
    if (bone.joint == dBoneHinge) return {about_hinge(D, axes.twist), 0, 0};
    const Mat3 turn = to_matrix(D);
    const Vec3 t = turn * axes.twist, s = transposed_times(turn, axes.swing);
    const Real cos_b =
        std::sqrt(dot(t, axes.twist) * dot(t, axes.twist) + dot(t, axes.across) * dot(t, axes.across));
    return {atan2(dot(s, axes.across), dot(s, axes.swing)), atan2(-dot(t, axes.swing), cos_b),
            atan2(dot(t, axes.across), dot(t, axes.twist))};
}

Vec3 rotation_vector(Quat q)
{
    if (q.w < 0) q = {-q.w, -q.x, -q.y, -q.z};
    const Real s = length(q.vec());
    return s > 0 ? (2 * atan2(s, q.w) / s) * q.vec() : Vec3{};
}

}  // namespace epode
