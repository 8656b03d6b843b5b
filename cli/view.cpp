// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See view.h.
#include "cli/view.h"

#include "cli/numbers.h"
#include "cli/paths.h"
#include "cli/plan.h"

namespace epode::cli {

void add_view_options(CLI::App& command, view::ViewOptions& options)
{
    const CLI::Validator side = whole_number_within(64, 4096);
    command
        .add_option("what", options.what,
                    "one of `epode list`, a recording (.epr) or a robot (.urdf, .xml, .sdf)")
        ->required();
    command.add_option("--stepper", options.stepper,
                       "exact, quick, fast or hybrid; default: the scene's own");
    command.add_option("--dt", options.dt, "step size in seconds; default: the scene's own")
        ->check(number_within(1e-9, 1e9));
    command.add_option("--iterations", options.iterations, "sweeps of quick, substeps of fast and hybrid")
        ->check(whole_number_within(1, kMaxIterations));
    command.add_option("--threads", options.threads, "threads of a step (default 1)")
        ->check(whole_number_within(1, kMaxThreads));
    command.add_option("--seed", options.seed, "of the scenes that are poured at random (default 1)");
    command.add_option("--width", options.width, "of the window, pixels")->check(side);
    command.add_option("--height", options.height, "of the window, pixels")->check(side);
    command.add_flag("--diagnose", options.diagnose,
                     "look for what makes the simulation fail (a panel shows it)");
    command.add_flag("--paused", options.paused, "begin paused");
    command.add_flag("--status", options.status, "a line on standard output whenever the state changes");
    command.add_flag("--headless", options.headless, "no window, as where there is no display");
    command.add_option("--frames", options.frames, "end after so many frames of 1/60 s")
        ->check(whole_number_within(1, 10'000'000));
    command.add_option("--picture", options.picture, "PNG file of the last frame, panels and all");
    command.add_option("--script", options.script, "what a user would do, without a window: docs/viewer.md");
}

#ifdef EPODE_HAVE_VIEW

int view(const view::ViewOptions& options)
{
    std::string problem;
    if (!options.picture.empty() && !can_write(options.picture, problem))
        return complain(options.picture, problem);
    return view::view(options);
}

#else

int view(const view::ViewOptions&)
{
    return refuse(
        "this build has no viewer: it wants Dear ImGui, GLFW, epoxy, EGL and stb (Debian: scripts/setup view "
        "installs libimgui-dev libglfw3-dev libepoxy-dev libegl-dev libstb-dev), then cmake again");
}

#endif

}  // namespace epode::cli
