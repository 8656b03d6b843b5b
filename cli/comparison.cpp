// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See comparison.h.
#include "cli/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/console.h"
#include "cli/plan.h"
#include "record/file/hash.h"
#include "record/rerun/compare.h"

namespace epode::cli {

namespace {

using record::Recording;

double span_of(const record::StepDistance& d) { return std::isfinite(d.pos) ? d.pos : HUGE_VAL; }

void describe_difference(const Recording& a, const Recording& b, FieldList& out)
{
    const auto first = record::first_difference(a, b);
    out.raw("identical", first || a.steps.size() != b.steps.size() ? "false" : "true");
    if (!first) {
        out.raw("first_step", "null", "result",
                fmt::format("the same in all {} states that both have",
                            std::min(a.steps.size(), b.steps.size())));
        return;
    }
    out.number(
        "first_step", double(first->step), "first difference",
        fmt::format("step {} (t = {:.6g} s), body {}", first->step, a.steps[first->step].time, first->body));
    out.number("first_body", first->body);
    out.number("time", a.steps[first->step].time);
    out.number("position", first->pos, "position", fmt::format("{:.3g} m apart", first->pos));
    out.number("rotation", first->turn, "rotation", fmt::format("{:.3g} rad", first->turn));
    out.number("velocity", first->linear, "velocity", fmt::format("{:.3g} m/s", first->linear));
    out.number("angular_velocity", first->angular, "angular velocity",
               fmt::format("{:.3g} rad/s", first->angular));
    out.string("hash_a", record::as_text(a.steps[first->step].hash));
    out.string("hash_b", record::as_text(b.steps[first->step].hash));
}

// How far apart over time: a tenth of the way, two tenths ... the end.
void describe_distances(const Recording& a, const Recording& b, FieldList& out)
{
    const size_t last = std::min(a.steps.size(), b.steps.size()) - 1;
    for (size_t tenth = 1; tenth <= 10; ++tenth) {
        const size_t step = last * tenth / 10;
        const record::StepDistance d = record::worst_distance(a, b, step);
        out.number(fmt::format("distance_{}", tenth).c_str(), span_of(d), tenth == 1 ? "farthest body" : " ",
                   fmt::format("t = {:.4g} s: {:.3g} m, {:.3g} rad (body {})", a.steps[step].time, d.pos,
                               d.turn, d.body));
    }
}

}  // namespace

int report(FieldList& out, bool json, bool fine)
{
    const auto fields = out.take();
    put(json ? as_json(fields) : as_table(fields));
    return fine ? kFine : kProblem;
}

int compare(const Recording& a, const Recording& b, bool only_distances, FieldList& out, bool json)
{
    const std::string why = record::incomparable(a, b);
    if (!why.empty()) {
        out.raw("identical", "false");
        out.string("incomparable", why, "result", "cannot be compared: " + why);
        return report(out, json, false);
    }
    out.number("states_a", double(a.steps.size()), "states",
               fmt::format("{} and {}", a.steps.size(), b.steps.size()));
    out.number("states_b", double(b.steps.size()));
    const bool same = !record::first_difference(a, b) && a.steps.size() == b.steps.size();
    describe_difference(a, b, out);
    if (!same) describe_distances(a, b, out);
    return report(out, json, same || only_distances);
}

}  // namespace epode::cli
