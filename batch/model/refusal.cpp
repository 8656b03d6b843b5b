// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a batch cannot take: one sentence that names the element.
#include "batch/model/refusal.h"

#include "robots/kinematics.h"

namespace epode::batch {

using namespace robots;

namespace {

std::string named(const char* what, const std::string& name) { return std::string(what) + " '" + name + "'"; }

std::string refused_joint(const Joint& joint)
{
    if (joint.is_scalar()) return {};
    const bool acts = joint.stiffness > 0 || joint.friction > 0 || joint.limited;
    return acts ? named("joint", joint.name) +
                      ": a batch has no springs, dry friction or limits of ball and free joints"
                : "";
}

std::string refused_actuator(const Actuator& actuator)
{
    if (actuator.joint < 0)
        return named("actuator", actuator.name) + ": a batch drives joints only, not tendons";
    if (actuator.filter.kind != Activation::Kind::kNone)
        return named("actuator", actuator.name) + ": a batch has no filters between control and force";
    return {};
}

std::string refused_link(const Link& link, size_t number)
{
    if (number > 0 && !link.joints.empty() && !(link.mass > 0))
        return named("link", link.name) + ": moves, but has no mass";
    if (!link.boxes.empty()) return named("link", link.name) + ": a batch has no medium";
    return {};
}

// Several robots in one model share nothing but the world, so only the first joint of a link may be free.
std::string refused_free(const RobotModel& model)
{
    for (const Joint& joint : model.joints) {
        if (joint.kind != JointKind::kFree) continue;
        const Link& link = model.links[size_t(joint.link)];
        if (link.parent != 0 || link.joints.size() != 1)
            return named("joint", joint.name) +
                   ": a free joint must stand alone between its link and the world";
    }
    return {};
}

}  // namespace

std::string refusal_of(const RobotModel& model)
{
    if (model.has_errors()) return "the model has errors: see its report";
    if (number_of_velocities(model) == 0) return "the model has no joints: nothing of it moves";
    if (!model.couplings.empty())
        return named("coupling", model.couplings[0].name) + ": a batch has no couplings";
    if (!model.closures.empty()) return named("loop", model.closures[0].name) + ": a batch has no loops";
    for (const Tendon& tendon : model.tendons)
        if (!tendon.path.empty() || tendon.stiffness > 0 || tendon.damping > 0 || tendon.low > -kInfinity ||
            tendon.high < kInfinity)
            return named("tendon", tendon.name) + ": a batch has no tendons";
    std::string problem = refused_free(model);
    for (size_t i = 0; i < model.links.size() && problem.empty(); ++i)
        problem = refused_link(model.links[i], i);
    for (size_t i = 0; i < model.joints.size() && problem.empty(); ++i)
        problem = refused_joint(model.joints[i]);
    for (size_t i = 0; i < model.actuators.size() && problem.empty(); ++i)
        problem = refused_actuator(model.actuators[i]);
    return problem;
}

}  // namespace epode::batch
