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

std::string refused_terms(const RobotModel& model, const char* what, const std::string& name,
                          const std::vector<Coupling::Term>& terms)
{
    bool moves = false;
    for (const Coupling::Term& term : terms) {
        if (!model.joints[size_t(term.joint)].is_scalar())
            return named(what, name) + ": a batch sums coordinates of hinges and sliders only";
        moves |= term.factor != 0;
    }
    return moves ? "" : named(what, name) + ": a batch needs a factor that is not 0";
}

std::string refused_joint(const Joint& joint)
{
    if (joint.is_scalar()) return {};
    const bool acts = joint.stiffness > 0 || joint.friction > 0 || joint.limited;
    return acts ? named("joint", joint.name) +
                      ": a batch has no springs, dry friction or limits of ball and free joints"
                : "";
}

// A spatial one that nothing acts on is only measured.
std::string refused_tendon(const RobotModel& model, size_t number)
{
    const Tendon& its = model.tendons[number];
    if (its.friction > 0 || its.armature > 0)
        return named("tendon", its.name) + ": a batch has no dry friction and no armature of tendons";
    if (its.path.empty()) return refused_terms(model, "tendon", its.name, its.terms);
    bool acts = its.stiffness > 0 || its.damping > 0 || its.low > -kInfinity || its.high < kInfinity;
    for (const Actuator& a : model.actuators) acts |= a.tendon == int(number);
    return acts ? named("tendon", its.name) + ": a batch has no tendons with a path" : "";
}

std::string refused_sums(const RobotModel& model)
{
    if (!model.ties.empty())
        return named("equality of tendons", model.ties[0].name) + ": a batch has no tendons with a path";
    std::string problem;
    for (size_t i = 0; i < model.couplings.size() && problem.empty(); ++i)
        problem = refused_terms(model, "coupling", model.couplings[i].name, model.couplings[i].terms);
    for (size_t i = 0; i < model.tendons.size() && problem.empty(); ++i) problem = refused_tendon(model, i);
    return problem;
}

std::string refused_actuator(const RobotModel& model)
{
    for (const Actuator& its : model.actuators)
        if (its.wrench.link >= 0 || its.adhesive_link >= 0)
            return named("actuator", its.name) +
                   ": a batch has no actuators of sites, no slider-cranks and no adhesion";
    for (const Actuator& its : model.actuators)
        if (its.muscle.acts || its.gain_position != 0 || its.gain_velocity != 0)
            return named("actuator", its.name) +
                   ": a batch has no muscles and no gains that depend on lengths";
    for (const Actuator& its : model.actuators)
        if (its.joint >= 0 && !model.joints[size_t(its.joint)].is_scalar())
            return named("actuator", its.name) + ": a batch has no actuators of balls";
    return {};
}

std::string refused_link(const Link& link, size_t number)
{
    if (!link.lifts.empty())
        return named("link", link.name) + ": a batch pulls links whole or not at all (gravcomp)";
    if (number > 0 && !link.joints.empty() && !(link.mass > 0))
        return named("link", link.name) + ": moves, but has no mass";
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
    std::string problem = refused_free(model);
    if (problem.empty()) problem = refused_actuator(model);
    if (problem.empty()) problem = refused_sums(model);
    for (size_t i = 0; i < model.links.size() && problem.empty(); ++i)
        problem = refused_link(model.links[i], i);
    for (size_t i = 0; i < model.joints.size() && problem.empty(); ++i)
        problem = refused_joint(model.joints[i]);
    return problem;
}

}  // namespace epode::batch
