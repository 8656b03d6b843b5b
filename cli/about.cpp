// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers travel as text with 17 digits, which is enough for every double to come back as itself.
#include "cli/about.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "scenes/extensions.h"

namespace epode::cli {

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
            {"contacts", plan.world_contacts ? "managed" : "joints"},
            {"precision", record::kPrecision},
            {"library", scenes::loaded_library()},
            {"library_kind", scenes::loaded_library_kind()},
            {"library_configuration", dGetConfiguration()}};
}

std::string other_precision(const record::Recording& recording)
{
    const std::string made_in = recording.about_value("precision");
    if (made_in == record::kPrecision) return {};
    return fmt::format("it was made in {} precision, this program computes in {}", made_in,
                       record::kPrecision);
}

bool options_from(const record::Recording& recording, RunOptions& options, std::string& problem)
{
    options.scene = recording.about_value("scene");
    if (recording.about_value("source") != "scene" || options.scene.empty()) {
        problem = "it was not made from a scene, so it cannot be run again here";
        return false;
    }
    problem = other_precision(recording);
    if (!problem.empty()) return false;
    options.stepper = recording.about_value("stepper");
    options.world_contacts = recording.about_value("contacts") == "managed";  // files from before say nothing
    options.dt = std::strtod(recording.about_value("dt").c_str(), nullptr);
    const long iterations = std::strtol(recording.about_value("iterations").c_str(), nullptr, 10);
    options.iterations = int(iterations);
    options.seed = std::uint32_t(std::strtoul(recording.about_value("seed").c_str(), nullptr, 10));
    if (!(std::isfinite(options.dt) && options.dt > 0) || iterations < 0 || iterations > kMaxIterations) {
        problem = "what it says about its own step size and iterations makes no sense";
        return false;
    }
    return true;
}

}  // namespace epode::cli
