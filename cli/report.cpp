// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What each figure means is said next to it, since it depends on the scene: energy is conserved only where
// there is no friction, motor or impact, momentum only where nothing outside acts. Elsewhere the same figures
// tell how much went, not how wrong it is.
#include "cli/report.h"

#include <fmt/format.h>

#include <cmath>

namespace epode::cli {

namespace {

using scenes::quantile;
using scenes::RunRecord;
using scenes::Scene;
using scenes::StepTimes;

double relative(double value, double scale) { return scale > 0 ? value / scale : 0; }

// A length that may be nanometres or metres.
std::string meters(double value)
{
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size >= 0.1) return fmt::format("{:.3g} m", value);
    if (size >= 1e-4) return fmt::format("{:.3g} mm", value * 1e3);
    if (size >= 1e-7) return fmt::format("{:.3g} um", value * 1e6);
    return fmt::format("{:.1e} m", value);
}

std::string milliseconds(double value) { return fmt::format("{:.3g} ms", value); }

std::string percent(double part)
{
    const double size = std::abs(part);
    return size == 0 || size >= 1e-5 ? fmt::format("{:+.3g} %", 100 * part) : fmt::format("{:+.1e}", part);
}

std::vector<double> pick(const RunRecord& record, double (*part)(const StepTimes&))
{
    std::vector<double> values;
    values.reserve(record.times.size());
    for (const StepTimes& times : record.times) values.push_back(part(times));
    return values;
}

// What steps, and who said so. Exact rotation and parts are what dWorldStep has: the others do not look at
// them.
std::string describe_stepper(const Scene& scene, const RunPlan& plan)
{
    std::string text = scenes::name_of(plan.stepper);
    if (plan.iterations > 0) text += fmt::format(", {} iterations", plan.iterations);
    if (plan.stepper == scenes::Stepper::kExact && scene.precise_parts() > 0)
        text += fmt::format(", {} parts a step, exact rotation", scene.precise_parts());
    text += plan.world_contacts ? ", world-managed contacts" : ", contact joints";
    if (plan.threads > 1) text += fmt::format(", {} threads", plan.threads);
    if (plan.recommended)
        text += plan.world_contacts ? " (the default for games)" : " (this scene's default)";
    return text;
}

void describe_setting(const Scene& scene, const RunPlan& plan, const RunRecord& record,
                      const Outcome& outcome, FieldList& out)
{
    out.string("scene", scene.recipe().name, "scene",
               fmt::format("{} - {}", scene.recipe().name, scene.recipe().description));
    out.string("stepper", scenes::name_of(plan.stepper), "stepper", describe_stepper(scene, plan));
    out.raw("stepper_is_default", plan.recommended ? "true" : "false");
    out.raw("world_contacts", plan.world_contacts ? "true" : "false");
    out.number("threads", plan.threads);
    out.number("exact_parts", scene.precise_parts());
    out.number("iterations", plan.iterations);
    out.number("seed", plan.seed);
    out.number("dt", plan.dt);
    out.number(
        "steps", record.steps, "steps",
        fmt::format(
            "{} of {:.4g} ms, {:.4g} s simulated{}", record.steps, plan.dt * 1e3, scene.time(),
            record.steps < plan.steps ? fmt::format(" (stopped early, {} were asked)", plan.steps) : ""));
    out.number("steps_asked", plan.steps);
    out.number("seconds", scene.time());
    out.string("library", outcome.library, "library", outcome.library);
}

void describe_size(const Scene& scene, const RunRecord& record, FieldList& out)
{
    out.number("bodies", double(scene.bodies().size()), "bodies", fmt::format("{}", scene.bodies().size()));
    out.number("joints", double(scene.joints().size()), "joints", fmt::format("{}", scene.joints().size()));
    out.number("contacts_mean", record.contacts_mean(), "contacts",
               fmt::format("{:.1f} mean, {} most", record.contacts_mean(), record.contacts_max));
    out.number("contacts_max", double(record.contacts_max));
}

void describe_time(const RunRecord& record, FieldList& out)
{
    const auto total = pick(record, [](const StepTimes& t) { return t.total_ms(); });
    const double median = quantile(total, 0.5), p99 = quantile(total, 0.99);
    const double collide = quantile(pick(record, [](const StepTimes& t) { return t.collide_ms; }), 0.5);
    const double step = quantile(pick(record, [](const StepTimes& t) { return t.step_ms; }), 0.5);
    out.number("ms_median", median, "time a step",
               fmt::format("{} median, {} p99 (collide {}, step {})", milliseconds(median), milliseconds(p99),
                           milliseconds(collide), milliseconds(step)));
    out.number("ms_p99", p99);
    out.number("ms_collide_median", collide);
    out.number("ms_step_median", step);
}

void describe_errors(const Scene& scene, const RunPlan& plan, const RunRecord& record, FieldList& out)
{
    const bool touched = record.contacts_max > 0;
    const scenes::Impact& impact = record.touching.at_impact;
    const std::string at_impact =
        impact.depth > 0
            ? fmt::format("{} at impact (step {}; met at {:.3g} m/s, {} a step)", meters(impact.depth),
                          impact.step, impact.speed, meters(impact.speed * plan.dt))
            : "none at impact";
    out.number(
        "penetration", record.penetration, "worst penetration",
        touched ? fmt::format("{} at rest, {}", meters(record.touching.at_rest), at_impact) : "no contacts");
    out.number("penetration_at_rest", record.touching.at_rest);
    out.number("penetration_at_impact", impact.depth);
    out.number("penetration_at_impact_step", impact.step);
    out.number("penetration_at_impact_speed", impact.speed);
    out.number("joint_error", record.joint_error, "worst joint error",
               scene.joints().empty() ? "no joints" : meters(record.joint_error));
    if (record.has_residual) {
        out.number("residual", record.residual, "worst residual", fmt::format("{:.2e}", record.residual));
        out.number("rows_max", record.rows_max);
        out.number("fallbacks", record.fallbacks);
        out.number("contained_islands", record.contained_islands);
    } else {
        out.raw("residual", "null", "worst residual", "not available from this library");
    }
}

void describe_energy(const Scene& scene, const RunRecord& record, FieldList& out)
{
    const double change = relative(record.last.energy() - record.first.energy(), record.energy_scale);
    const double rise = relative(record.energy_peak_rise, record.energy_scale);
    const char* meaning = scene.conservative
                              ? "nothing here takes energy: a drift is the stepper's error at this step size"
                              : "friction, impacts or motors act";
    out.number("energy_start", record.first.energy());
    out.number("energy_end", record.last.energy());
    out.number("energy_change", change, "energy drift",
               fmt::format("{}, highest rise {} of {:.3g} J moved ({})", percent(change), percent(rise),
                           record.energy_scale, meaning));
    out.number("energy_rise", rise);
    out.raw("energy_conserved_by_scene", scene.conservative ? "true" : "false", {}, {});
}

void describe_momentum(const Scene& scene, const RunRecord& record, FieldList& out)
{
    const double linear = relative(record.momentum_drift, record.momentum_scale);
    const double spin = relative(record.spin_drift, record.spin_scale);
    const std::string text =
        scene.isolated
            ? fmt::format(
                  "linear {:.1e}, angular {:.1e} relative (nothing acts from outside: a drift is the "
                  "stepper's error)",
                  linear, spin)
            : fmt::format("not an isolated scene: supports gave up to {:.3g} kg m/s against gravity",
                          record.momentum_drift);
    out.number("momentum_drift", record.momentum_drift, "momentum drift", text);
    out.number("momentum_drift_relative", linear);
    out.number("angular_momentum_drift", record.spin_drift);
    out.number("angular_momentum_drift_relative", spin);
    out.raw("momentum_conserved_by_scene", scene.isolated ? "true" : "false", {}, {});
    out.number("max_speed", record.max_speed, "fastest body", fmt::format("{:.3g} m/s", record.max_speed));
}

}  // namespace

std::vector<Field> describe(const Scene& scene, const RunPlan& plan, const RunRecord& record,
                            const Outcome& outcome)
{
    FieldList out;
    describe_setting(scene, plan, record, outcome, out);
    describe_size(scene, record, out);
    describe_time(record, out);
    describe_errors(scene, plan, record, out);
    describe_energy(scene, record, out);
    describe_momentum(scene, record, out);
    out.number("nans", record.not_finite, "NaNs", fmt::format("{}", record.not_finite));
    out.number("messages", outcome.messages, "messages", fmt::format("{}", outcome.messages));
    out.raw("step_failed", outcome.step_failed ? "true" : "false", {}, {});
    return out.take();
}

}  // namespace epode::cli
