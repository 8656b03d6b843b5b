// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What scripts/demo shows first: the scene `wall` as a picture and a trace, as `epode run wall --picture P --trace T` makes them. A program
// of its own because it is built of the few parts that this takes (CMakeLists.txt), in a quarter of the time.
#include <cmath>
#include <cstdio>

#include "cli/picture.h"
#include "cli/trace.h"
#include "scenes/measure.h"

namespace {

using namespace epode;

int fail(const char* path, const std::string& why)
{
    std::fprintf(stderr, "epode_demo: cannot write '%s': %s\n", path, why.c_str());
    return 1;
}

int show(const scenes::Recipe& recipe, const char* picture, const char* trace_path)
{
    scenes::Scene scene(recipe);
    const scenes::Setting setting = scenes::recommended(recipe);
    std::string problem;
    if (setting.world_contacts && !scene.manage_contacts(problem)) return fail(picture, problem);
    cli::Trace trace;
    if (!trace.open(trace_path, scene)) return fail(trace_path, trace.problem());
    scenes::RunRecord record(scene);
    const int steps = int(std::ceil(recipe.seconds / recipe.dt - 1e-9));
    for (int i = 0; i < steps; ++i) {
        if (!scene.step(setting.stepper, recipe.dt)) return fail(picture, "a step failed");
        trace.add(scene, record.observe(scene), record);
    }
    if (!trace.close()) return fail(trace_path, trace.problem());
    if (!cli::save_picture(scene, picture, problem)) return fail(picture, problem);
    std::printf("%s: %s; %zu bodies, %d steps of %g ms\n", recipe.name, recipe.description,
                scene.bodies().size(), steps, 1e3 * recipe.dt);
    return 0;
}

}  // namespace

int main(int count, char** words)
{
    if (count != 3) return std::fprintf(stderr, "usage: epode_demo PICTURE TRACE\n"), 2;
    const scenes::Runtime runtime;
    return show(*scenes::find_recipe("wall"), words[1], words[2]);
}
