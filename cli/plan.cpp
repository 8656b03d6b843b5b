// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See plan.h. Every refusal says what would be right.
#include "cli/plan.h"

#include <fmt/format.h>

#include <cmath>

#include "scenes/extensions.h"

namespace epode::cli {

namespace {

constexpr int kMaxSteps = 100'000'000;

}  // namespace

int refuse(const std::string& problem)
{
    fmt::print(stderr, "epode: {}\n", problem);
    return kUsage;
}

int complain(const std::string& path, const std::string& why)
{
    fmt::print(stderr, "epode: '{}': {}\n", path, why);
    return kProblem;
}

std::string no_such_scene(const std::string& name)
{
    return fmt::format("there is no scene '{}'. Scenes:{}", name, scenes::scene_names());
}

bool settle(const RunOptions& options, const scenes::Recipe& recipe, RunPlan& plan, std::string& problem)
{
    plan.stepper = recipe.stepper;
    if (!options.stepper.empty() && !scenes::stepper_named(options.stepper, plan.stepper)) {
        problem = scenes::no_such_stepper(options.stepper);
        return false;
    }
    if (!scenes::available(plan.stepper)) {
        problem = fmt::format("{} has no '{}' stepper. Steppers it has: exact quick",
                              scenes::loaded_library(), scenes::name_of(plan.stepper));
        return false;
    }
    plan.dt = options.dt > 0 ? options.dt : recipe.dt;
    const double seconds = options.seconds > 0 ? options.seconds : recipe.seconds;
    const double steps = options.steps > 0 ? options.steps : std::ceil(seconds / plan.dt - 1e-9);
    if (!(steps >= 1 && steps <= kMaxSteps)) {
        problem = fmt::format("{:g} s at a step of {:g} s is not between 1 and {} steps", seconds, plan.dt,
                              kMaxSteps);
        return false;
    }
    plan.steps = int(steps);
    plan.seed = options.seed;
    plan.iterations = options.iterations;
    return true;
}

}  // namespace epode::cli
