// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See world_options.h.
#include "integrations/gazebo/world_options.h"

#include <algorithm>

#include "integrations/gazebo/convert.h"

namespace epode::gazebo {

namespace {

struct SolverName {
    const char* name;
    int stepper;
};
constexpr SolverName kSolvers[] = {{"hybrid", dStepperHybrid},    {"world", dStepperExact},
                                   {"exact", dStepperExact},      {"dantzig", dStepperExact},
                                   {"quick", dStepperQuick},      {"pgs", dStepperQuick},
                                   {"substeps", dStepperSubsteps}};

const std::string kNone;

std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return char(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    return text;
}

}  // namespace

bool choose_solver(World& world, const std::string& name)
{
    const std::string wanted = lower_case(name);
    for (const SolverName& solver : kSolvers)
        if (wanted == solver.name) {
            dWorldSetHybridStepper(world.world, solver.stepper);
            world.solver = solver.name;
            return true;
        }
    EPODE_GAZEBO_ERROR << "solver '" << name << "' was refused: there are hybrid, exact (world, dantzig), "
                       << "quick (pgs) and substeps; '" << world.solver << "' stays\n";
    return false;
}

void WorldOptions::SetWorldGravity(const Identity& world, const Eigen::Vector3d& gravity)
{
    World* const found = get<World>(world);
    if (!found) return;
    dWorldSetGravity(found->world, gravity.x(), gravity.y(), gravity.z());
    // A body that sleeps where it lay would not see it.
    for (const auto& model : found->models)
        for (const auto& link : model->links)
            if (link->body) dBodyEnable(link->body);
}

Eigen::Vector3d WorldOptions::GetWorldGravity(const Identity& world) const
{
    const World* const found = get<World>(world);
    dVector3 gravity{};
    if (found) dWorldGetGravity(found->world, gravity);
    return {gravity[0], gravity[1], gravity[2]};
}

void WorldOptions::SetWorldSolver(const Identity& world, const std::string& name)
{
    if (World* const found = get<World>(world)) choose_solver(*found, name);
}

const std::string& WorldOptions::GetWorldSolver(const Identity& world) const
{
    const World* const found = get<World>(world);
    return found ? found->solver : kNone;
}

void WorldOptions::SetWorldCollisionDetector(const Identity& world, const std::string& name)
{
    World* const found = get<World>(world);
    if (found && lower_case(name) != found->detector)
        EPODE_GAZEBO_WARNING << "collision detector '" << name << "' is none of ours: '" << found->detector
                             << "', which has all pairs of shapes, stays\n";
}

const std::string& WorldOptions::GetWorldCollisionDetector(const Identity& world) const
{
    const World* const found = get<World>(world);
    return found ? found->detector : kNone;
}

}  // namespace epode::gazebo
