// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Replay builds the scene again, steps it as the recording says and records it into memory; then it is a
// diff. A step is compared by hash first, and only where hashes differ by its numbers.
#include "cli/replay.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/about.h"
#include "cli/comparison.h"
#include "cli/console.h"
#include "cli/export.h"
#include "cli/fields.h"
#include "cli/interrupt.h"
#include "cli/paths.h"
#include "cli/plan.h"
#include "cli/progress.h"
#include "cli/rerun.h"
#include "cli/robot.h"
#include "record/file/hash.h"
#include "record/file/reader.h"
#include "scenes/messages.h"
#include "view/session/scene_recorder.h"

namespace epode::cli {

namespace {

using record::Recording;

// True when the recording can be used.
bool load(const std::string& path, bool partial, Recording& recording)
{
    const record::ReadResult result = record::read_file(path, recording);
    if (result.whole()) return true;
    const bool usable = result.damage == record::Damage::kBreaksOff && !recording.steps.empty();
    if (usable && partial) {
        warn("'{}': {}; going on with these", path, result.problem);
        return true;
    }
    complain(path, result.problem + (usable ? " (--partial takes these)" : ""));
    return false;
}

// The recording's run again; with as many steps as it has.
int simulate_again(const Recording& was, const RunOptions& run, const RunPlan& plan, bool quiet,
                   Recording& now)
{
    scenes::Runtime runtime;
    scenes::MessageCounter messages;
    scenes::Scene scene(*scenes::find_recipe(run.scene), plan.seed);
    std::string problem;
    if (!set_up(scene, plan, problem)) return refuse(problem);
    now.info(about(scene, plan));
    view::SceneRecorder recorder(scene, now);
    recorder.state(scenes::measure(scene), 0);
    Progress progress(run.scene, plan.steps, !quiet);
    for (size_t i = 1; i < was.steps.size(); ++i) {
        if (!scene.step(plan.stepper, plan.dt)) {
            warn("the library reports that step {} failed", i);
            return kProblem;
        }
        recorder.state(scenes::measure(scene), plan.dt);
        progress.show(int(i), scene.contacts().size());
    }
    return kFine;
}

// The hash that the file says of each state must be that of the state itself.
bool hashes_fit(const Recording& recording, size_t& step)
{
    for (step = 0; step < recording.steps.size(); ++step) {
        if (record::hash_states(recording.steps[step].bodies) != recording.steps[step].hash) return false;
    }
    return true;
}

// By number of the state.
std::string hashes_as_json(const Recording& recording)
{
    std::string list;
    for (const record::Step& step : recording.steps)
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ",", record::as_text(step.hash));
    return "[" + list + "]";
}

}  // namespace

int replay(const ReplayOptions& options)
{
    Recording was, now;
    std::string problem;
    if (!options.output.empty() && !can_write(options.output, problem))
        return complain(options.output, problem);
    if (!load(options.file, options.partial, was)) return kProblem;
    if (was.steps.empty()) return complain(options.file, "it has no state");
    if (was.about_value("source") == "program") return rerun(options, was);
    if (!options.output.empty() || !options.contacts.empty())
        return refuse(
            "--output and --contacts are for recordings of programs; a scene's run is recorded by `epode "
            "record`");
    RunOptions run;
    if (!options_from(was, run, problem)) return refuse(fmt::format("'{}': {}", options.file, problem));
    const bool other =
        (!options.stepper.empty() && options.stepper != run.stepper) || options.iterations >= 0;
    if (!options.stepper.empty()) run.stepper = options.stepper;
    if (options.iterations >= 0) run.iterations = options.iterations;
    run.steps = int(std::max<size_t>(1, was.steps.size() - 1));
    if (!offer_robot(run.scene, false, problem)) return complain(run.scene, problem);
    const scenes::Recipe* recipe = scenes::find_recipe(run.scene);
    if (!recipe) return refuse(no_such_scene(run.scene));
    RunPlan plan;
    if (!settle(run, *recipe, plan, problem)) return refuse(problem);
    size_t step = 0;
    if (!hashes_fit(was, step))
        return complain(options.file, fmt::format("the hash of state {} is not its own", step));
    if (const int code = simulate_again(was, run, plan, options.quiet, now)) return code;

    FieldList out;
    out.string("scene", run.scene, "scene", run.scene);
    out.string(
        "stepper", run.stepper, "stepper",
        other ? fmt::format("{}, recorded with {}", run.stepper, was.about_value("stepper")) : run.stepper);
    return compare(was, now, other, out, options.json);
}

int diff(const ReplayOptions& options)
{
    Recording a, b;
    if (!load(options.file, options.partial, a) || !load(options.other, options.partial, b)) return kProblem;
    FieldList out;
    return compare(a, b, false, out, options.json);
}

int convert(const ReplayOptions& options)
{
    std::string problem;
    if (!can_export(options.other, problem)) return refuse(problem);
    if (!can_write(options.other, problem)) return complain(options.other, problem);
    Recording recording;
    if (!load(options.file, options.partial, recording)) return kProblem;
    const Interruptible file_is_made_whole;
    if (!export_recording(recording, options.other, options.fps, problem))
        return complain(options.other, problem);
    return interruption() ? interruption_code() : int(kFine);
}

int inspect(const ReplayOptions& options)
{
    Recording recording;
    if (!load(options.file, options.partial, recording)) return kProblem;
    size_t wrong = 0;
    const bool fit = hashes_fit(recording, wrong);
    if (!fit) complain(options.file, fmt::format("the hash of state {} is not its own", wrong));
    if (options.hashes && !options.json) {
        for (size_t i = 0; i < recording.steps.size() && can_say(); ++i)
            say("{} {}\n", i, record::as_text(recording.steps[i].hash));
        return fit ? kFine : kProblem;
    }
    FieldList out;
    if (options.hashes) {
        out.raw("hashes", hashes_as_json(recording));
        return report(out, options.json, fit);
    }
    for (const auto& [key, value] : recording.about) out.string(key.c_str(), value, key, value);
    const auto count = [&](const char* key, size_t number) {
        out.number(key, double(number), key, fmt::format("{}", number));
    };
    count("states", recording.steps.size());
    count("bodies", recording.bodies.size());
    count("geoms", recording.geoms.size());
    count("shapes", recording.shapes.size());
    count("joints", recording.joints.size());
    size_t contacts = 0;
    for (const record::Step& step : recording.steps) contacts += step.contacts.size();
    count("contacts", contacts);
    if (!recording.steps.empty()) {
        const record::Step& last = recording.steps.back();
        out.number("seconds", last.time, "seconds", fmt::format("{:.6g}", last.time));
        out.string("last_hash", record::as_text(last.hash), "last hash", record::as_text(last.hash));
    }
    return report(out, options.json, fit);
}

}  // namespace epode::cli
