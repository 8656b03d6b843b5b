// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See plan.h. Every refusal says what would be right.
#include "cli/plan.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/console.h"
#include "cli/suggest.h"
#include "scenes/extensions.h"

namespace epode::cli {

namespace {

constexpr int kMaxSteps = 100'000'000;
constexpr double kMaxPictures = 1'000'000;

bool choose_stepper(const RunOptions& options, const scenes::Recipe& recipe, RunPlan& plan,
                    std::string& problem)
{
    const scenes::Setting setting = scenes::recommended(recipe);
    plan.stepper = setting.stepper;
    plan.recommended = options.stepper.empty() && !options.world_contacts;
    plan.world_contacts = options.world_contacts || (options.stepper.empty() && setting.world_contacts);
    if (!options.stepper.empty() && !scenes::stepper_named(options.stepper, plan.stepper)) {
        problem = no_such_stepper(options.stepper);
    } else if (!scenes::available(plan.stepper)) {
        problem = fmt::format("{} has no '{}' stepper. Steppers it has: exact quick",
                              scenes::loaded_library(), scenes::name_of(plan.stepper));
    } else if (plan.world_contacts && !scenes::has_world_contacts()) {
        problem = scenes::loaded_library() + " has no world-managed contacts (--world-contacts)";
    } else if (plan.threads > 1 && !scenes::has_step_threads()) {
        problem = scenes::loaded_library() + " steps on one thread only (--threads)";
    }
    return problem.empty();
}

}  // namespace

int refuse(const std::string& problem)
{
    warn("{}", problem);
    return kUsage;
}

int complain(const std::string& path, const std::string& why)
{
    warn("'{}': {}", path, why);
    return kProblem;
}

std::string no_such_scene(const std::string& name)
{
    return fmt::format("there is no scene '{}'.{} Scenes:{}", name, did_you_mean(name, scenes::scene_list()),
                       scenes::scene_names());
}

std::string no_such_stepper(const std::string& name)
{
    std::vector<std::string> names;
    for (scenes::Stepper stepper : scenes::kSteppers) names.emplace_back(scenes::name_of(stepper));
    return scenes::no_such_stepper(name) + "." + did_you_mean(name, names);
}

bool set_up(scenes::Scene& scene, const RunPlan& plan, std::string& problem)
{
    scene.set_iterations(plan.iterations);
    if (plan.threads > 1) scenes::set_step_threads(scene.world(), plan.threads);
    return !plan.world_contacts || scene.manage_contacts(problem);
}

bool settle(const RunOptions& options, const scenes::Recipe& recipe, RunPlan& plan, std::string& problem)
{
    problem.clear();
    plan.threads = options.threads;
    if (!choose_stepper(options, recipe, plan, problem)) return false;
    plan.dt = options.dt > 0 ? options.dt : recipe.dt;
    const double seconds = options.seconds > 0 ? options.seconds : recipe.seconds;
    const double steps = options.steps > 0 ? options.steps : std::ceil(seconds / plan.dt - 1e-9);
    if (!(steps >= 1 && steps <= kMaxSteps)) {
        problem = fmt::format("{:g} s at a step of {:g} s is not between 1 and {} steps", seconds, plan.dt,
                              kMaxSteps);
        return false;
    }
    plan.steps = int(steps);
    if (!options.video.empty() && steps * plan.dt * options.fps > kMaxPictures) {
        problem = fmt::format("{:g} s at {:g} pictures a second are more than {:g} pictures", steps * plan.dt,
                              options.fps, kMaxPictures);
        return false;
    }
    plan.seed = options.seed;
    plan.iterations = options.iterations;
    const bool substeps = plan.stepper == scenes::Stepper::kFast || plan.stepper == scenes::Stepper::kHybrid;
    if (substeps && options.iterations > kMaxSubsteps) {
        problem = fmt::format("{} substeps are more than {}", options.iterations, kMaxSubsteps);
        return false;
    }
    return true;
}

}  // namespace epode::cli
