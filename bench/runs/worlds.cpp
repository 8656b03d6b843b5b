// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Each way has worlds of its own, all alike; the ways take turns, round after round, and the quickest round
// of each counts. In a call with several steps the worlds are in the cache for longer and the threads meet
// less often: both are shown. At the end all ways must have the same bits, or the program fails. Names of our
// library only are asked for at run time.
#include "bench/runs/worlds.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "bench/engines/ode_scene.h"
#include "bench/engines/stopwatch.h"
#include "bench/scenes/recipe.h"

namespace epode::bench {

namespace {

using SetSpace = void (*)(dWorldID, dSpaceID);
using StepMany = int (*)(const dWorldID*, int, dReal, int, int, int, int, int*);

template <class Function>
Function find(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

struct Way {
    const char* text;
    int threads;   // 0: a loop of single steps
    int per_call;  // steps of a call
    std::vector<std::unique_ptr<OdeScene>> scenes = {};
    std::vector<dWorldID> worlds = {};
    double best = 1e300;  // ms of a round
};

constexpr int kSubsteps = 4;

// As dStepper in ode/steppers.h.
int number_of(const std::string& stepper) { return stepper == "exact" ? 1 : stepper == "fast" ? 3 : 4; }

bool run_round(Way& way, const WorldsOptions& options, double dt)
{
    static const StepMany step_many = find<StepMany>("dWorldsStep");
    const int count = int(way.worlds.size());
    for (int i = 0; i < options.steps; i += way.per_call) {
        if (way.threads == 0) {
            for (auto& scene : way.scenes)
                if (!scene->advance()) return false;
        } else if (step_many(way.worlds.data(), count, dReal(dt), number_of(options.stepper), kSubsteps,
                             way.per_call, way.threads, nullptr) != count) {
            return false;
        }
    }
    return true;
}

bool same_states(const Way& a, const Way& b)
{
    State left, right;
    for (size_t i = 0; i < a.scenes.size(); ++i) {
        a.scenes[i]->read(left);
        b.scenes[i]->read(right);
        for (size_t k = 0; k < left.size(); ++k)
            if (left[k].pos.x != right[k].pos.x || left[k].pos.z != right[k].pos.z) return false;
    }
    return true;
}

}  // namespace

int bench_worlds(const WorldsOptions& options)
{
    const auto data = make_scene({options.scene, false, options.size, 0});
    const auto set_space = find<SetSpace>("dWorldSetContactSpace");
    if (!data || !set_space || !find<StepMany>("dWorldsStep")) {
        fmt::print(stderr, "epode_bench: no such scene, or a library without dWorldsStep\n");
        return 1;
    }
    EngineOptions engine;
    engine.stepper = options.stepper;
    engine.iterations = options.stepper == "fast" ? kSubsteps : 0;
    Way ways[] = {{"loop of single steps", 0, 1},
                  {"one call, 1 thread", 1, 1},
                  {"one call, 2 threads", 2, 1},
                  {"a call for all steps, 1 thread", 1, options.steps},
                  {"a call for all steps, 2 threads", 2, options.steps}};
    for (Way& way : ways)
        for (int i = 0; i < options.worlds; ++i) {
            way.scenes.push_back(std::make_unique<OdeScene>(*data, engine));
            way.worlds.push_back(way.scenes.back()->world());
            set_space(way.worlds.back(), way.scenes.back()->space());
        }
    for (int round = 0; round < options.rounds; ++round)
        for (Way& way : ways) {
            Stopwatch watch(true);
            if (!run_round(way, options, data->dt)) return 1;
            way.best = std::min(way.best, watch.lap());
        }
    const double steps = double(options.worlds) * options.steps;
    fmt::print("{} worlds of {}, size {}, {}, {} steps\n", options.worlds, options.scene, options.size,
               options.stepper, options.rounds * options.steps);
    for (const Way& way : ways)
        fmt::print("{:32} {:10.0f} world steps/s  x{:.2f}\n", way.text, 1e3 * steps / way.best,
                   ways[0].best / way.best);
    for (const Way& way : ways)
        if (!same_states(ways[0], way)) {
            fmt::print(stderr, "epode_bench: {} has other bits\n", way.text);
            return 1;
        }
    return 0;
}

}  // namespace epode::bench
