// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The run itself: settle what was asked, step, watch, report. Files are opened before the first step, so that
// a wrong path costs no time.
#include "cli/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/picture.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/trace.h"
#include "scenes/extensions.h"
#include "scenes/measure.h"
#include "scenes/messages.h"
#include "scenes/scene.h"

namespace epode::cli {

namespace {

constexpr int kMaxSteps = 100'000'000;

int refuse(const std::string& problem)
{
    fmt::print(stderr, "epode: {}\n", problem);
    return kUsage;
}

int unknown_scene(const std::string& name)
{
    std::string text = fmt::format("there is no scene '{}'. Scenes:", name);
    for (const scenes::Recipe* recipe : scenes::all_recipes()) text += fmt::format(" {}", recipe->name);
    return refuse(text);
}

// What was asked, completed by the scene's own values. False and a message on a contradiction or an
// impossible value.
bool settle(const RunOptions& options, const scenes::Recipe& recipe, RunPlan& plan, std::string& problem)
{
    plan.stepper = recipe.stepper;
    if (!options.stepper.empty() && !scenes::stepper_named(options.stepper, plan.stepper)) {
        problem = fmt::format("there is no stepper '{}'. Steppers: exact quick fast", options.stepper);
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

// Runs until done, or until numbers stop being numbers: what follows would say nothing. The rows of the trace
// are written as they come.
void simulate(scenes::Scene& scene, const RunPlan& plan, scenes::RunRecord& record, Trace& trace,
              Outcome& outcome, bool quiet)
{
    Progress progress(scene.recipe().name, plan.steps, !quiet);
    for (int i = 0; i < plan.steps; ++i) {
        outcome.step_failed = !scene.step(plan.stepper, plan.dt);
        trace.add(scene, record.observe(scene), record);
        progress.show(i + 1, scene.contacts().size());
        if (outcome.step_failed || record.not_finite > 0) return;
    }
}

bool write_picture(const scenes::Scene& scene, const std::string& path)
{
    std::string problem;
    if (path.empty() || save_picture(scene, path, problem)) return true;
    fmt::print(stderr, "epode: cannot write the picture '{}': {}\n", path, problem);
    return false;
}

int carry_out(const RunOptions& options, const scenes::Recipe& recipe, const RunPlan& plan)
{
    scenes::Runtime runtime;
    scenes::MessageCounter messages;
    scenes::Scene scene(recipe, plan.seed);
    scene.set_iterations(plan.iterations);

    Trace trace;
    if (!options.trace.empty() && !trace.open(options.trace, scene)) {
        fmt::print(stderr, "epode: cannot write the trace '{}': {}\n", options.trace, trace.problem());
        return kProblem;
    }

    scenes::RunRecord record(scene);
    Outcome outcome;
    simulate(scene, plan, record, trace, outcome, options.quiet);
    outcome.messages = messages.count();
    outcome.library = scenes::loaded_library();

    const bool drawn = write_picture(scene, options.picture);
    const bool traced = trace.close();
    if (!traced)
        fmt::print(stderr, "epode: cannot write the trace '{}': {}\n", options.trace, trace.problem());

    const auto fields = describe(scene, plan, record, outcome);
    fmt::print("{}", options.json ? as_json(fields) : as_table(fields));
    if (record.not_finite > 0) fmt::print(stderr, "epode: {} bodies are not finite\n", record.not_finite);
    if (outcome.step_failed) fmt::print(stderr, "epode: the library reports that the step failed\n");
    return drawn && traced && record.not_finite == 0 && !outcome.step_failed ? kFine : kProblem;
}

}  // namespace

int run(const RunOptions& options)
{
    const scenes::Recipe* recipe = scenes::find_recipe(options.scene);
    if (!recipe) return unknown_scene(options.scene);
    RunPlan plan;
    std::string problem;
    if (!settle(options, *recipe, plan, problem)) return refuse(problem);
    if (!options.picture.empty() && !can_draw())
        return refuse("this build has no viewer, so --picture is not to be had");
    return carry_out(options, *recipe, plan);
}

int list_scenes()
{
    size_t width = 0;
    for (const scenes::Recipe* recipe : scenes::all_recipes())
        width = std::max(width, std::string(recipe->name).size());
    for (const scenes::Recipe* recipe : scenes::all_recipes())
        fmt::print("{:<{}}  {}\n", recipe->name, width, recipe->description);
    return kFine;
}

}  // namespace epode::cli
