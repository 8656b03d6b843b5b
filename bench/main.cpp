// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// epode_bench: times scenes on whichever libode.so.8 the loader finds, and says which it was. bench/compare
// runs it on two of them in turn.
#include <CLI/CLI.hpp>

#include "bench/exact_sizes.h"
#include "bench/scene_bench.h"

int main(int argc, char** argv)
{
    CLI::App app("Times a scene: median, p10, p90 in ms per step, its parts, and the quality of the result.",
                 "epode_bench");
    epode::bench::SceneOptions options;
    app.add_option("scene", options.scene,
                   "a scene of `epode list`, or exact-sizes: islands of 12 to 300 rows")
        ->required();
    app.add_option("--stepper", options.stepper, "exact, quick or fast; default: the scene's own");
    app.add_option("--dt", options.dt, "step size in seconds; default: the scene's own")
        ->check(CLI::Range(1e-9, 1e9));
    app.add_option("--steps", options.steps, "number of steps; default: the scene's own, exact-sizes: 60")
        ->check(CLI::Range(1, 10'000'000));
    app.add_option("--repeat", options.repeat, "runs, each from a fresh start (default 3)")
        ->check(CLI::Range(1, 10'000));
    app.add_option("--iterations", options.iterations,
                   "sweeps of quick (default 20), small steps of fast (default 4)")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--seed", options.seed, "of scenes that are poured at random (default 1)");
    app.add_flag("--json", options.json, "print JSON");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }

    epode::scenes::Runtime runtime;
    if (options.scene != "exact-sizes") return epode::bench::bench_scene(options);
    if (!options.stepper.empty() && options.stepper != "exact") {
        std::fputs("epode_bench: exact-sizes times the exact stepper only\n", stderr);
        return 2;
    }
    epode::bench::SizesOptions sizes;
    if (options.steps > 0) sizes.steps = options.steps;
    sizes.repeat = options.repeat;
    sizes.json = options.json;
    return epode::bench::bench_exact_sizes(sizes);
}
