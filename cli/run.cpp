// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The run itself: settle what was asked, step, watch, report. Files are opened before the first step, so that
// a wrong path costs no time.
#include "cli/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/export.h"
#include "cli/outputs.h"
#include "cli/picture.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/trace.h"
#include "cli/video.h"
#include "scenes/extensions.h"
#include "scenes/measure.h"
#include "scenes/messages.h"
#include "scenes/scene.h"

namespace epode::cli {

namespace {

// Runs until done, or until numbers stop being numbers: what follows would say nothing. The rows of the trace
// are written as they come.
void simulate(scenes::Scene& scene, const RunPlan& plan, scenes::RunRecord& record, Trace& trace,
              Outputs& outputs, Video& video, Outcome& outcome, bool quiet)
{
    Progress progress(scene.recipe().name, plan.steps, !quiet);
    for (int i = 0; i < plan.steps; ++i) {
        outcome.step_failed = !scene.step(plan.stepper, plan.dt);
        const scenes::Quality quality = record.observe(scene);
        trace.add(scene, quality, record);
        outputs.step(quality);
        video.step(scene);
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

bool close_video(Video& video, const std::string& path)
{
    const bool filmed = video.close();
    if (!filmed) fmt::print(stderr, "epode: cannot make the video '{}': {}\n", path, video.problem());
    if (!video.remark().empty()) fmt::print(stderr, "epode: {}\n", video.remark());
    return filmed;
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

    Outputs outputs;
    if (!outputs.open(options, plan, scene)) {
        fmt::print(stderr, "epode: {}\n", outputs.problem());
        return kProblem;
    }

    Video video;
    if (!options.video.empty() && !video.open(options.video, options.fps, scene)) {
        fmt::print(stderr, "epode: cannot make the video '{}': {}\n", options.video, video.problem());
        return kProblem;
    }

    scenes::RunRecord record(scene);
    Outcome outcome;
    simulate(scene, plan, record, trace, outputs, video, outcome, options.quiet);
    outcome.messages = messages.count();
    outcome.library = scenes::loaded_library();

    const bool drawn = write_picture(scene, options.picture);
    const bool traced = trace.close();
    if (!traced)
        fmt::print(stderr, "epode: cannot write the trace '{}': {}\n", options.trace, trace.problem());

    const bool filmed = close_video(video, options.video);
    const bool recorded = outputs.close();
    if (!recorded) fmt::print(stderr, "epode: {}\n", outputs.problem());

    const auto fields = describe(scene, plan, record, outcome);
    fmt::print("{}", options.json ? as_json(fields) : as_table(fields));
    if (record.not_finite > 0) fmt::print(stderr, "epode: {} bodies are not finite\n", record.not_finite);
    if (outcome.step_failed) fmt::print(stderr, "epode: the library reports that the step failed\n");
    return drawn && traced && filmed && recorded && record.not_finite == 0 && !outcome.step_failed ? kFine
                                                                                                   : kProblem;
}

}  // namespace

int run(const RunOptions& options)
{
    const scenes::Recipe* recipe = scenes::find_recipe(options.scene);
    if (!recipe) return refuse(no_such_scene(options.scene));
    RunPlan plan;
    std::string problem;
    if (!settle(options, *recipe, plan, problem)) return refuse(problem);
    for (const std::string& path : options.records) {
        if (!can_export(path, problem)) return refuse(problem);
    }
    if (!options.picture.empty() && !can_draw())
        return refuse("this build has no viewer, so --picture is not to be had");
    if (!options.video.empty() && !Video::possible())
        return refuse("this build has no viewer, so --video is not to be had");
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
