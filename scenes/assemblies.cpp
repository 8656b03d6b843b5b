// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scenes/assemblies.h"

#include "record/watch/lookup.h"

namespace epode::scenes {

#define EPODE_FOUND(name) reinterpret_cast<decltype(&(name))>(record::library_function(#name))

namespace {

constexpr int kHumanBones = 16;

// Bodies that the library has made, each with its geom and the joints that it is body 1 of.
void adopt(Scene& scene, const std::vector<dBodyID>& bodies)
{
    for (const dBodyID body : bodies) {
        scene.add_body(body);
        scene.add_geom(dBodyGetFirstGeom(body));
        for (int i = dBodyGetNumJoints(body) - 1; i >= 0; --i)
            if (const dJointID joint = dBodyGetJoint(body, i); dJointGetBody(joint, 0) == body)
                scene.add_joint(joint);
    }
}

}  // namespace

dBodyID add_breakable(Scene& scene, const std::vector<dFracturePart>& parts, double strength, double radius)
{
    const auto create = EPODE_FOUND(dFractureCreate);
    const auto update = EPODE_FOUND(dFractureUpdate);
    if (!create || !update) return nullptr;
    scene.before_step([&scene, update, parts, strength, radius](double, double) {
        const dFracture one = {parts.data(), int(parts.size()), dReal(strength), dReal(radius)};
        update(scene.world(), &one, 1);
    });
    return create(scene.world(), parts.data(), int(parts.size()));
}

std::vector<dBodyID> add_human(Scene& scene, Vec at, Turn q, double height, double mass, double strength)
{
    const auto make = EPODE_FOUND(dBonesMakeHuman);
    const auto create = EPODE_FOUND(dRagdollCreate);
    const auto get_pose = EPODE_FOUND(dRagdollGetPose);
    const auto hold = EPODE_FOUND(dRagdollSetPose);
    if (!make || !create || !get_pose || !hold) return {};
    dBone bones[kHumanBones];
    std::vector<dBodyID> bodies(kHumanBones);
    const dVector3 position = {dReal(at.x), dReal(at.y), dReal(at.z)};
    const dQuaternion orientation = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    make(bones, kHumanBones, dReal(height), dReal(mass));
    create(scene.world(), scene.space(), bones, kHumanBones, position, orientation, bodies.data());
    dQuaternion pose[kHumanBones];
    get_pose(bones, bodies.data(), kHumanBones, pose);
    hold(bones, bodies.data(), kHumanBones, pose, dReal(strength));
    adopt(scene, bodies);
    return bodies;
}

dRopeSettings rope_settings()
{
    dRopeSettings settings{};
    if (const auto init = EPODE_FOUND(dRopeSettingsInit)) init(&settings, sizeof settings);
    return settings;
}

std::vector<dBodyID> add_rope(Scene& scene, Vec from, Vec to, const dRopeSettings& settings, dBodyID last)
{
    const auto create = EPODE_FOUND(dRopeCreate);
    if (!create) return {};
    std::vector<dBodyID> links(std::size_t(settings.links));
    const dVector3 a = {dReal(from.x), dReal(from.y), dReal(from.z)},
                   b = {dReal(to.x), dReal(to.y), dReal(to.z)};
    create(scene.world(), scene.space(), a, b, nullptr, last, &settings, links.data(), nullptr);
    adopt(scene, links);
    return links;
}

void blow_up(Scene& scene, Vec at, double radius, double impulse, unsigned long categories)
{
    const auto blow = EPODE_FOUND(dSpaceApplyRadialImpulse);
    const auto init = EPODE_FOUND(dQueryFilterInit);
    if (!blow || !init) return;
    dQueryFilter filter;
    init(&filter, sizeof filter);
    filter.category_bits = 0, filter.collide_bits = categories;
    const dVector3 center = {dReal(at.x), dReal(at.y), dReal(at.z)};
    blow(scene.space(), center, dReal(radius), dReal(impulse), dFalloffLinear, 1, &filter);
}

}  // namespace epode::scenes
