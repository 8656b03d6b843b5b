// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Humans of 1.8 m and 75 kg in a world with a preset, for the tests of ragdolls.
#pragma once

#include <array>

#include "rig.h"

namespace epode::assemblies {

using namespace physics;

inline constexpr int kBones = 16;
enum Part { kPelvis, kAbdomen, kThorax, kHead, kArm, kForearm, kHand, kThigh = 10, kShank, kFoot };

struct Stage {
    explicit Stage(int preset, double gravity = 9.81)
    {
        world = dWorldCreate();
        dWorldUseDefaults(world, preset);
        dWorldSetGravity(world, 0, 0, real(-gravity));
        space = dHashSpaceCreate(nullptr);
        dWorldSetContactSpace(world, space);
    }
    ~Stage()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space);
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    void floor() { dCreatePlane(space, 0, 0, 1, 0); }
    void step(double h) { dWorldStepHybrid(world, real(h)); }

    dWorldID world;
    dSpaceID space;
};

using Pose = std::array<dQuaternion, kBones>;

struct Figure {
    std::array<dBone, kBones> bones;
    std::array<dBodyID, kBones> bodies{};

    Figure() { dBonesMakeHuman(bones.data(), kBones, real(1.8), 75); }
    int build(const Stage& stage, V3 at = {}, double lean = 0)
    {
        const dVector3 position = {real(at.x), real(at.y), real(at.z)};
        const dQuaternion q = {real(std::cos(lean / 2)), real(std::sin(lean / 2)), 0, 0};
        return dRagdollCreate(stage.world, stage.space, bones.data(), kBones, position, q, bodies.data());
    }
    Pose pose() const
    {
        Pose out;
        dRagdollGetPose(bones.data(), bodies.data(), kBones, out.data());
        return out;
    }
    int hold(const Pose& pose, double strength = 1) const
    {
        return dRagdollSetPose(bones.data(), bodies.data(), kBones, pose.data(), real(strength));
    }
    int follow(V3 at, const Pose& pose, double weight, double h) const
    {
        const dVector3 position = {real(at.x), real(at.y), real(at.z)};
        return dRagdollFollow(bones.data(), bodies.data(), kBones, position, pose.data(), real(weight),
                              real(h));
    }
    double gap() const { return dRagdollGetGap(bones.data(), bodies.data(), kBones); }
};

// a b, of quaternions.
inline void product(const dReal* a, const dReal* b, dReal* out) { dQMultiply0(out, a, b); }

// The pose of the list with a bone turned about an axis of the figure.
inline void turn(const Figure& f, Pose& pose, int bone, V3 axis, double angle)
{
    const dReal* parent = f.bones[std::size_t(f.bones[std::size_t(bone)].parent)].orientation;
    dQuaternion by, seen, inverse = {parent[0], -parent[1], -parent[2], -parent[3]};
    dQFromAxisAndAngle(by, real(axis.x), real(axis.y), real(axis.z), real(angle));
    dQuaternion in_parent;
    product(inverse, by, seen), product(seen, parent, in_parent);
    dQuaternion before;
    for (int k = 0; k < 4; ++k) before[k] = pose[std::size_t(bone)][k];
    product(in_parent, before, pose[std::size_t(bone)]);
}

// The largest angle by which two poses differ in a bone other than the first.
inline double difference(const Pose& a, const Pose& b)
{
    double largest = 0;
    for (int i = 1; i < kBones; ++i) {
        double square = 0;  // of the vector of conj(a) b: the sine of half the angle
        dQuaternion between;
        dQMultiply1(between, a[std::size_t(i)], b[std::size_t(i)]);
        for (int k = 1; k < 4; ++k) square += between[k] * between[k];
        largest = std::fmax(largest, 2 * std::asin(std::fmin(1, std::sqrt(square))));
    }
    return largest;
}

}  // namespace epode::assemblies
