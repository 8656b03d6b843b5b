// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers travel as text with 17 digits, which is enough for every double to come back as itself.
#include "cli/scene_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "scenes/extensions.h"

namespace epode::cli {

namespace {

std::string value_of(const record::Info& info, const char* key)
{
    const auto found = info.find(key);
    return found == info.end() ? std::string() : found->second;
}

}  // namespace

SceneRecorder::SceneRecorder(scenes::Scene& scene, const RunPlan& plan, record::Sink& sink)
    : scene_(scene), plan_(plan), recorder_(sink)
{
    sink.info(about(scene, plan));
    scene.want_forces(true);
    sample(scenes::measure(scene), 0);
}

void SceneRecorder::step(const scenes::Quality& quality) { sample(quality, scene_.times().total_ms()); }

// Scenes only ever add.
void SceneRecorder::add_new()
{
    for (; bodies_ < scene_.bodies().size(); ++bodies_) recorder_.add(scene_.bodies()[bodies_]);
    for (; geoms_ < scene_.geoms().size(); ++geoms_) recorder_.add(scene_.geoms()[geoms_]);
    for (; joints_ < scene_.joints().size(); ++joints_) recorder_.add(scene_.joints()[joints_].joint);
}

void SceneRecorder::sample(const scenes::Quality& quality, double ms)
{
    add_new();
    contacts_.clear();
    for (const scenes::ContactRecord& from : scene_.contacts()) {
        record::ContactSeen& to = contacts_.emplace_back();
        to.geom[0] = from.geom1;
        to.geom[1] = from.geom2;
        to.depth = from.depth;
        std::copy_n(from.pos, 3, to.pos);
        std::copy_n(from.normal, 3, to.normal);
        std::copy_n(from.force, 3, to.force);
    }
    record::StepFigures figures;
    figures.time = scene_.time();
    figures.dt = scene_.time() > 0 ? plan_.dt : 0;
    figures.kinetic = quality.kinetic;
    figures.potential = quality.potential;
    figures.joint_error = quality.joint_error;
    figures.ms = ms;
    recorder_.step(figures, contacts_, true);
}

record::Info about(const scenes::Scene& scene, const RunPlan& plan)
{
    return {{"source", "scene"},
            {"scene", scene.recipe().name},
            {"description", scene.recipe().description},
            {"stepper", scenes::name_of(plan.stepper)},
            {"dt", fmt::format("{:.17g}", plan.dt)},
            {"steps", fmt::format("{}", plan.steps)},
            {"iterations", fmt::format("{}", plan.iterations)},
            {"seed", fmt::format("{}", plan.seed)},
            {"precision", sizeof(dReal) == 8 ? "double" : "single"},
            {"library", scenes::loaded_library()}};
}

bool options_from(const record::Info& info, RunOptions& options, std::string& problem)
{
    options.scene = value_of(info, "scene");
    if (value_of(info, "source") != "scene" || options.scene.empty()) {
        problem = "it was not made from a scene, so it cannot be run again here";
        return false;
    }
    const std::string precision = sizeof(dReal) == 8 ? "double" : "single";
    if (value_of(info, "precision") != precision) {
        problem = fmt::format("it was made in {} precision, this program computes in {}",
                              value_of(info, "precision"), precision);
        return false;
    }
    options.stepper = value_of(info, "stepper");
    options.dt = std::strtod(value_of(info, "dt").c_str(), nullptr);
    options.iterations = int(std::strtol(value_of(info, "iterations").c_str(), nullptr, 10));
    options.seed = std::uint32_t(std::strtoul(value_of(info, "seed").c_str(), nullptr, 10));
    if (!(std::isfinite(options.dt) && options.dt > 0) || options.iterations < 0) {
        problem = "what it says about its own step size and iterations makes no sense";
        return false;
    }
    return true;
}

}  // namespace epode::cli
