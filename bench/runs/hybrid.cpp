// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One thread, 1/60 s, CPU time of the process.
#include "bench/runs/hybrid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "bench/engines/stopwatch.h"
#include "bench/runs/game_worlds.h"

namespace epode::bench {
namespace {

constexpr dReal kH = dReal(1.0 / 60);
constexpr int kHybrid = 0, kSubsteps = 3;  // of dStepper

struct Times {
    double mean = 0, median = 0, p99 = 0, worst = 0;  // ms
};

Times run(const GameWorldRecipe& row, int count, int stepper, int steps)
{
    GameWorld scene(stepper);
    row.build(scene, count);
    const auto step = find<MakeStep>("dWorldStepHybrid");
    std::vector<double> times;
    for (int i = 0; i < steps; ++i) {
        Stopwatch watch(false);
        step(scene.world, kH);
        times.push_back(watch.lap());
    }
    std::sort(times.begin(), times.end());
    Times out;
    for (double t : times) out.mean += t / double(times.size());
    out.median = times[times.size() / 2], out.p99 = times[times.size() * 99 / 100], out.worst = times.back();
    return out;
}

void print(const Times& t)
{
    fmt::print(" {:.2f} | {:.2f} | {:.2f} | {:.2f} |", t.mean, t.median, t.p99, t.worst);
}

// Hybrid steps of one world.
int bench_one(const HybridOptions& options)
{
    for (const GameWorldRecipe& row : game_worlds()) {
        if (options.only != row.name) continue;
        const int count = options.size > 0 ? options.size : row.count;
        fmt::print("| {} {} |", count, row.name);
        print(run(row, count, kHybrid, options.steps));
        fmt::print("\n");
        return 0;
    }
    fmt::print(stderr, "epode_bench: no world is called {}\n", options.only);
    return 1;
}

}  // namespace

int bench_hybrid(const HybridOptions& options)
{
    if (!find<MakeStep>("dWorldStepHybrid") || !find<SetNumber>("dWorldUseDefaults")) {
        fmt::print(stderr, "epode_bench: a library without dWorldStepHybrid\n");
        return 1;
    }
    if (!options.only.empty()) return bench_one(options);
    fmt::print(
        "| world, ms | substeps: mean | median | p99 | worst | hybrid: mean | median | p99 | worst "
        "| mean of substeps' | worst of substeps' |\n");
    fmt::print("|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const GameWorldRecipe& row : game_worlds()) {
        if (row.large && !options.large) continue;
        const Times substeps = run(row, row.count, kSubsteps, options.steps);
        const Times hybrid = run(row, row.count, kHybrid, options.steps);
        fmt::print("| {} {} |", row.count, row.name);
        print(substeps), print(hybrid);
        fmt::print(" {:.2f} | {:.2f} |\n", hybrid.mean / substeps.mean, hybrid.worst / substeps.worst);
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace epode::bench
