// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The run itself: settle what was asked, step, watch, report. Files are tried before the first step, so that
// a wrong path costs no time, and closed before the report, which may go to a pipe that nobody reads.
#include "cli/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/console.h"
#include "cli/export.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/paths.h"
#include "cli/picture.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/trace.h"
#include "cli/video.h"
#include "scenes/causes.h"
#include "scenes/extensions.h"
#include "scenes/measure.h"
#include "scenes/messages.h"
#include "scenes/scene.h"

namespace epode::cli {

namespace {

// Runs until done, interrupted, or numbers stop being numbers: what follows would say nothing. The rows of
// the trace are written as they come.
void simulate(scenes::Scene& scene, const RunPlan& plan, scenes::RunRecord& record, Trace& trace,
              Outputs& outputs, Video& video, Outcome& outcome, bool quiet)
{
    Progress progress(scene.recipe().name, plan.steps, !quiet);
    for (int i = 0; i < plan.steps && !interruption(); ++i) {
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
    warn("cannot write the picture '{}': {}", path, problem);
    return false;
}

bool close_video(Video& video, const std::string& path)
{
    const bool filmed = video.close();
    if (!filmed) warn("cannot make the video '{}': {}", path, video.problem());
    if (!video.remark().empty()) warn("{}", video.remark());
    return filmed;
}

int fail(const char* what, const std::string& path, const std::string& why)
{
    warn("cannot {} '{}': {}", what, path, why);
    return kProblem;
}

// What the files hold that were being written when the signal came.
int say_interrupted(const RunOptions& options, const scenes::RunRecord& record, const RunPlan& plan)
{
    warn("interrupted after step {} of {}", record.steps, plan.steps);
    for (const std::string& path : options.records)
        warn("'{}' is whole and has the {} states until then", path, record.steps + 1);
    return interruption_code();
}

// The likeliest causes of what went wrong; next to an object of JSON they go to standard error.
void put_diagnosis(const std::vector<scenes::Cause>& causes, bool json)
{
    if (causes.empty() && !json) say("diagnosis: nothing found\n");
    for (const scenes::Cause& cause : causes)
        json ? warn("{}", cause.text) : say("diagnosis: {}\n", cause.text);
}

int carry_out(const RunOptions& options, const scenes::Recipe& recipe, const RunPlan& plan)
{
    scenes::Runtime runtime;
    scenes::MessageCounter messages;
    scenes::Scene scene(recipe, plan.seed);
    std::string problem;
    if (!set_up(scene, plan, problem)) return refuse(problem);

    if (options.diagnose && !scenes::set_diagnosis(scene.world(), true))
        return refuse("this library does not diagnose steps, so --diagnose is not to be had");

    const Interruptible files_are_made_whole;
    Trace trace;
    if (!options.trace.empty() && !trace.open(options.trace, scene))
        return fail("write the trace", options.trace, trace.problem());
    Outputs outputs;
    if (!outputs.open(options, plan, scene)) {
        warn("{}", outputs.problem());
        return kProblem;
    }
    Video video;
    if (!options.video.empty() && !video.open(options.video, options.fps, scene))
        return fail("make the video", options.video, video.problem());

    scenes::RunRecord record(scene);
    Outcome outcome;
    simulate(scene, plan, record, trace, outputs, video, outcome, options.quiet);
    outcome.messages = messages.count();
    outcome.library = scenes::loaded_library();

    constexpr size_t kCauses = 3;
    const std::vector<scenes::Cause> causes = scenes::causes_of(scene, kCauses);
    outputs.diagnosis(causes);
    const bool drawn = write_picture(scene, options.picture);
    const bool traced = trace.close();
    if (!traced) fail("write the trace", options.trace, trace.problem());
    const bool filmed = close_video(video, options.video);
    const bool recorded = outputs.close();
    if (!recorded) warn("{}", outputs.problem());

    const auto fields = describe(scene, plan, record, outcome);
    put(options.json ? as_json(fields) : as_table(fields));
    if (options.diagnose) put_diagnosis(causes, options.json);
    if (record.not_finite > 0) warn("{} bodies are not finite", record.not_finite);
    if (outcome.step_failed) warn("the library reports that the step failed");
    if (!(drawn && traced && filmed && recorded && record.not_finite == 0 && !outcome.step_failed))
        return kProblem;
    return interruption() ? say_interrupted(options, record, plan) : int(kFine);
}

// Of all files at once, before anything is done. No two of them may be one.
bool check_paths(const RunOptions& options, int& code)
{
    std::vector<std::string> paths = options.records;
    for (const std::string& path : {options.trace, options.picture, options.video}) {
        if (!path.empty()) paths.push_back(path);
    }
    std::string problem;
    for (size_t i = 0; i < paths.size(); ++i) {
        if (std::count(paths.begin(), paths.end(), paths[i]) > 1) {
            code = refuse(fmt::format("'{}' is named for two files", paths[i]));
            return false;
        }
        if (!can_write(paths[i], problem)) {
            code = complain(paths[i], problem);
            return false;
        }
    }
    return true;
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
    int code = kFine;
    return check_paths(options, code) ? carry_out(options, *recipe, plan) : code;
}

int list_scenes()
{
    size_t width = 0;
    for (const scenes::Recipe* recipe : scenes::all_recipes())
        width = std::max(width, std::string(recipe->name).size());
    for (const scenes::Recipe* recipe : scenes::all_recipes())
        say("{:<{}}  {}\n", recipe->name, width, recipe->description);
    return kFine;
}

}  // namespace epode::cli
