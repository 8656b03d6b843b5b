// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// epode: simulates a named scene, judges the result, shows a picture. This file is the command line alone.
#include <CLI/CLI.hpp>

#include "cli/run.h"

namespace {

using epode::cli::RunOptions;

void add_run_options(CLI::App& command, RunOptions& options)
{
    const CLI::Range positive(1e-9, 1e9);
    command.add_option("scene", options.scene, "one of `epode list`")->required();
    command.add_option("--stepper", options.stepper, "exact, quick or fast; default: the scene's own");
    command.add_option("--dt", options.dt, "step size in seconds; default: the scene's own")->check(positive);
    auto* steps =
        command.add_option("--steps", options.steps, "number of steps")->check(CLI::Range(1, 100'000'000));
    auto* seconds =
        command.add_option("--seconds", options.seconds, "simulated time; default: the scene's own")
            ->check(positive);
    steps->excludes(seconds);
    command
        .add_option("--iterations", options.iterations,
                    "sweeps of quick (default 20), small steps of fast (default 4)")
        ->check(CLI::Range(1, 1'000'000));
    command.add_option("--seed", options.seed, "of the scenes that are poured at random (default 1)");
    command.add_flag("--json", options.json, "report as one JSON object");
    command.add_flag("--quiet", options.quiet, "no progress on stderr");
    command.add_option("--picture", options.picture, "PNG file of the last state");
    command.add_option("--trace", options.trace, "CSV file, one line per step");
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Simulates a scene with the ODE interface, judges the result, shows a picture.", "epode");
    app.require_subcommand(1);
    app.footer("Exit codes: 0 fine, 1 a problem was found, 2 wrong usage.");
    CLI::App* list = app.add_subcommand("list", "names the scenes");
    CLI::App* run = app.add_subcommand("run", "runs a scene and reports");
    RunOptions options;
    add_run_options(*run, options);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? epode::cli::kFine : epode::cli::kUsage;
    }
    if (list->parsed()) return epode::cli::list_scenes();
    return epode::cli::run(options);
}
