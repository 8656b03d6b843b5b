// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Each problem is timed twice: cold, every step from nothing, and warm, from the forces of the step before,
// which had other velocities (a library without warm starting is timed once). Every step starts from another
// of a few states, the same for every library. The report of the residual costs time, and therefore is asked for in
// steps of their own. Memory: what the process's peak grew by from before the world was made to after its
// timed steps; exact when a process runs one problem only, for a peak never falls.
#include "bench/problems/exact_table.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "bench/problems/problem_list.h"
#include "scenes/extensions.h"
#include "scenes/measure.h"
#include "scenes/messages.h"

namespace epode::bench {

namespace {

constexpr std::uint32_t kStates = 7;
constexpr int kLeastSteps = 3;

long peak_kilobytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

double median_step(Problem& problem, const TableOptions& options)
{
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    const auto start = Clock::now();
    problem.prepare(0);
    problem.step();
    for (int i = 0; i < options.steps; ++i) {
        problem.prepare(std::uint32_t(i + 1) % kStates);
        times.push_back(problem.step());
        const bool late = std::chrono::duration<double>(Clock::now() - start).count() > options.seconds;
        if (late && int(times.size()) >= kLeastSteps) break;
    }
    return scenes::quantile(times, 0.5);
}

struct Quality {
    double residual = -1;  // -1: the library does not tell
    int fallbacks = 0, contained = 0, islands = 0;
};

Quality judge(Problem& problem)
{
    Quality quality;
    if (!scenes::request_step_report(problem.world(), true)) return quality;
    for (std::uint32_t draw = 0; draw < kStates; ++draw) {
        problem.prepare(draw);
        problem.step();
        const auto report = scenes::step_report(problem.world());
        if (!report) continue;
        quality.residual = std::max(quality.residual, report->residual);
        quality.fallbacks += report->fallbacks;
        quality.contained += report->contained_islands;
        quality.islands = report->islands;
    }
    scenes::request_step_report(problem.world(), false);
    return quality;
}

bool finite(const Problem& problem)
{
    for (dBodyID body : problem.bodies()) {
        for (const dReal* v : {dBodyGetLinearVel(body), dBodyGetAngularVel(body)}) {
            if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2])) return false;
        }
    }
    return true;
}

void write_velocities(const Problem& problem, const std::string& name, std::FILE* file)
{
    for (dBodyID body : problem.bodies()) {
        const dReal *v = dBodyGetLinearVel(body), *w = dBodyGetAngularVel(body);
        fmt::print(file, "{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", name, v[0], v[1], v[2], w[0],
                   w[1], w[2]);
    }
}

// False: the problem cannot be made, or a number that is not finite came out.
bool run_problem(const ProblemRecipe& recipe, const TableOptions& options, std::FILE* velocities)
{
    const scenes::MessageCounter messages;
    const long before = peak_kilobytes();
    const auto problem = std::make_unique<Problem>();
    if (!build_problem(*problem, recipe)) return false;

    problem->prepare(0);
    problem->step();
    if (velocities) write_velocities(*problem, recipe.name, velocities);
    const bool sound = finite(*problem);

    const double warm = median_step(*problem, options);
    const long grown = peak_kilobytes() - before;
    double cold = warm;
    if (scenes::set_warm_starting(problem->world(), 0)) cold = median_step(*problem, options);
    const Quality quality = judge(*problem);
    const int copies = recipe.copies;
    fmt::print("{} {} {:.6f} {:.6f} {:.3e} {} {} {} {} {}\n", recipe.name, problem->rows() / copies,
               cold / copies, warm / copies, quality.residual, quality.islands, quality.fallbacks,
               quality.contained, grown, messages.count());
    std::fflush(stdout);
    return sound;
}

bool take_steps(const ProblemRecipe& recipe, const TableOptions& options)
{
    Problem problem;
    if (!build_problem(problem, recipe)) return false;
    if (options.untimed == "cold") scenes::set_warm_starting(problem.world(), 0);
    for (int i = 0; i < options.steps; ++i) {
        problem.prepare(std::uint32_t(i) % kStates);
        problem.step();
    }
    fmt::print("{} {} {} {}\n", recipe.name, problem.rows() / recipe.copies, recipe.copies, options.steps);
    return finite(problem);
}

}  // namespace

int bench_exact_table(const TableOptions& options)
{
    if (!options.problem.empty() && !find_problem(options.problem)) {
        std::string names;
        for (const ProblemRecipe& known : all_problems()) names += fmt::format(" {}", known.name);
        fmt::print(stderr, "epode_bench: there is no problem '{}'. Problems:{}\n", options.problem, names);
        return 2;
    }
    std::FILE* velocities =
        options.velocities.empty() ? nullptr : std::fopen(options.velocities.c_str(), "w");
    if (!options.velocities.empty() && !velocities) {
        fmt::print(stderr, "epode_bench: cannot write {}\n", options.velocities);
        return 2;
    }
    fmt::print(
        "# library {}\n# name rows ms_cold ms_warm residual islands fallbacks contained kilobytes messages\n",
        scenes::loaded_library());
    bool sound = true;
    for (const ProblemRecipe& recipe : all_problems()) {
        if (!options.problem.empty() && options.problem != recipe.name) continue;
        sound = (options.untimed.empty() ? run_problem(recipe, options, velocities)
                                         : take_steps(recipe, options)) &&
                sound;
    }
    if (velocities) std::fclose(velocities);
    return sound ? 0 : 1;
}

}  // namespace epode::bench
