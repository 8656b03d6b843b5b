// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every repeat makes the same scene again and gives the same contacts, so step i costs the same work each
// time: the least of its times over the repeats is what it costs, the rest is the machine's other business.
// Quantiles are then taken over the steps. Measuring stands outside the timed parts; the step report is left
// off while timing, for it is not free.
#include "bench/runs/scene_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/extensions.h"
#include "scenes/measure.h"
#include "scenes/messages.h"

namespace epode::bench {

namespace {

using scenes::quantile;
using scenes::StepTimes;

struct Figures {
    std::vector<StepTimes> best;  // per step, the least over the repeats
    double penetration = 0, penetration_mean = 0, penetration_end = 0, joint_error = 0;
    double energy_start = 0, energy_end = 0, kinetic_end = 0;
    double contacts_sum = 0;
    size_t contacts_max = 0;
    int not_finite = 0;
    int messages = 0;
    bool failed = false;
};

void keep_least(StepTimes& least, const StepTimes& now)
{
    least.collide_ms = std::min(least.collide_ms, now.collide_ms);
    least.step_ms = std::min(least.step_ms, now.step_ms);
    least.empty_ms = std::min(least.empty_ms, now.empty_ms);
}

void run_once(const SceneOptions& options, const scenes::Recipe& recipe, scenes::Stepper stepper, double dt,
              int steps, bool first, Figures& figures)
{
    scenes::Scene scene(recipe, options.seed);
    scene.set_iterations(options.iterations);
    if (first) figures.energy_start = scenes::measure(scene).energy();
    for (int i = 0; i < steps; ++i) {
        figures.failed = !scene.step(stepper, dt) || figures.failed;
        if (!first) {
            keep_least(figures.best[size_t(i)], scene.times());
            continue;
        }
        figures.best.push_back(scene.times());
        const double depth = scenes::penetration(scene);
        figures.penetration = std::max(figures.penetration, depth);
        figures.penetration_mean += depth / steps;
        figures.penetration_end = depth;
        figures.joint_error = std::max(figures.joint_error, scenes::worst_joint_error(scene));
        figures.contacts_sum += double(scene.contacts().size());
        figures.contacts_max = std::max(figures.contacts_max, scene.contacts().size());
    }
    const scenes::Quality end = scenes::measure(scene);
    figures.energy_end = end.energy();
    figures.kinetic_end = end.kinetic;
    figures.not_finite += end.not_finite;
}

std::vector<double> pick(const std::vector<StepTimes>& times, double (*part)(const StepTimes&))
{
    std::vector<double> values;
    for (const StepTimes& t : times) values.push_back(part(t));
    return values;
}

struct Line {
    std::string key, text;
    bool quoted = false;
};

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : "null"; }

std::vector<Line> describe(const Figures& figures, const scenes::Recipe& recipe, scenes::Stepper stepper,
                           double dt, const SceneOptions& options)
{
    const auto total = pick(figures.best, [](const StepTimes& t) { return t.total_ms(); });
    const auto part = [&](double (*f)(const StepTimes&)) {
        return number(quantile(pick(figures.best, f), 0.5));
    };
    return {{"scene", recipe.name, true},
            {"library", scenes::loaded_library(), true},
            {"stepper", scenes::name_of(stepper), true},
            {"iterations", number(options.iterations)},
            {"dt", number(dt)},
            {"steps", number(double(figures.best.size()))},
            {"repeat", number(options.repeat)},
            {"contacts_mean", number(figures.contacts_sum / double(figures.best.size()))},
            {"contacts_max", number(double(figures.contacts_max))},
            {"ms_median", number(quantile(total, 0.5))},
            {"ms_p10", number(quantile(total, 0.1))},
            {"ms_p90", number(quantile(total, 0.9))},
            {"ms_collide", part([](const StepTimes& t) { return t.collide_ms; })},
            {"ms_step", part([](const StepTimes& t) { return t.step_ms; })},
            {"ms_empty", part([](const StepTimes& t) { return t.empty_ms; })},
            {"penetration_worst", number(figures.penetration)},
            {"penetration_mean", number(figures.penetration_mean)},
            {"penetration_end", number(figures.penetration_end)},
            {"joint_error", number(figures.joint_error)},
            {"energy_start", number(figures.energy_start)},
            {"energy_end", number(figures.energy_end)},
            {"kinetic_end", number(figures.kinetic_end)},
            {"nans", number(figures.not_finite)},
            {"messages", number(figures.messages)}};
}

void print(const std::vector<Line>& lines, bool json)
{
    if (json) fmt::print("{{\n");
    for (size_t i = 0; i < lines.size(); ++i) {
        const Line& line = lines[i];
        const char* quote = line.quoted ? "\"" : "";
        if (json) {
            fmt::print("  \"{}\": {}{}{}{}\n", line.key, quote, line.text, quote,
                       i + 1 < lines.size() ? "," : "");
        } else {
            fmt::print("{:<18} {}\n", line.key, line.text);
        }
    }
    if (json) fmt::print("}}\n");
}

int refuse(const std::string& problem)
{
    fmt::print(stderr, "epode_bench: {}\n", problem);
    return 2;
}

}  // namespace

int bench_scene(const SceneOptions& options)
{
    const scenes::Recipe* recipe = scenes::find_recipe(options.scene);
    if (!recipe)
        return refuse(fmt::format("there is no scene '{}'. Scenes:{}", options.scene, scenes::scene_names()));
    scenes::Stepper stepper = recipe->stepper;
    if (!options.stepper.empty() && !scenes::stepper_named(options.stepper, stepper)) {
        return refuse(scenes::no_such_stepper(options.stepper));
    }
    if (!scenes::available(stepper))
        return refuse(
            fmt::format("{} has no '{}' stepper", scenes::loaded_library(), scenes::name_of(stepper)));

    const double dt = options.dt > 0 ? options.dt : recipe->dt;
    const int steps = options.steps > 0 ? options.steps : int(std::ceil(recipe->seconds / dt - 1e-9));
    const scenes::MessageCounter messages;
    Figures figures;
    for (int i = 0; i < options.repeat; ++i) run_once(options, *recipe, stepper, dt, steps, i == 0, figures);
    figures.messages = messages.count();
    print(describe(figures, *recipe, stepper, dt, options), options.json);
    return figures.failed || figures.not_finite > 0 ? 1 : 0;
}

}  // namespace epode::bench
