// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "cli/world_file.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "cli/console.h"
#include "cli/fields.h"
#include "cli/interrupt.h"
#include "cli/paths.h"
#include "scenes/extensions.h"
#include "scenes/messages.h"
#include "scenes/scene.h"

namespace epode::cli {

namespace {

constexpr const char* kEnding = ".epw";

std::string no_files() { return scenes::loaded_library() + " has no files of worlds (dWorldSave)"; }

// Its library says why not, by its message.
class LoadedWorld {
  public:
    explicit LoadedWorld(const std::string& path) : world_(scenes::load_world(path, space_)) {}
    LoadedWorld(const LoadedWorld&) = delete;
    LoadedWorld& operator=(const LoadedWorld&) = delete;
    ~LoadedWorld()
    {
        if (world_) dWorldDestroy(world_);
        if (space_) dSpaceDestroy(space_);
    }
    explicit operator bool() const { return world_ != nullptr; }
    dWorldID world() const { return world_; }
    dSpaceID space() const { return space_; }

  private:
    dSpaceID space_ = nullptr;
    dWorldID world_;
};

int count_geoms(dSpaceID space)
{
    int count = 0;
    for (int i = 0; space && i < dSpaceGetNumGeoms(space); ++i) {
        const dGeomID geom = dSpaceGetGeom(space, i);
        count += dGeomIsSpace(geom) ? count_geoms(reinterpret_cast<dSpaceID>(geom)) : 1;
    }
    return count;
}

void put_counts(FieldList& fields, const std::string& path, const LoadedWorld& loaded)
{
    const std::vector<dBodyID> bodies = scenes::bodies_of(loaded.world());
    int sleeping = 0;
    for (const dBodyID body : bodies) sleeping += !dBodyIsEnabled(body);
    const int joints = scenes::joint_count(loaded.world()), geoms = count_geoms(loaded.space());
    fields.string("world", path, "world", path);
    fields.number("bodies", double(bodies.size()), "bodies",
                  fmt::format("{}, {} of them disabled or asleep", bodies.size(), sleeping));
    fields.number("sleeping", sleeping);
    fields.number("joints", joints, "joints", fmt::format("{}", joints));
    fields.number("geoms", geoms, "geoms", fmt::format("{}", geoms));
    const bool world_contacts = scenes::contact_space(loaded.world()) != nullptr;
    fields.raw("world_contacts", world_contacts ? "true" : "false", "contacts",
               world_contacts ? "managed by the world" : "of the program");
}

struct Motion {
    double max_speed = 0;
    int not_finite = 0;
};

Motion motion_of(dWorldID world)
{
    Motion motion;
    for (const dBodyID body : scenes::bodies_of(world)) {
        const dReal *v = dBodyGetLinearVel(body), *p = dBodyGetPosition(body);
        const double speed = std::hypot(double(v[0]), double(v[1]), double(v[2]));
        motion.not_finite += !std::isfinite(speed + double(p[0]) + double(p[1]) + double(p[2]));
        motion.max_speed = std::fmax(motion.max_speed, speed);
    }
    return motion;
}

int step(dWorldID world, const RunPlan& plan)
{
    const dReal h = dReal(plan.dt);
    if (plan.stepper == scenes::Stepper::kExact) return dWorldStep(world, h);
    const int substeps = plan.iterations > 0 ? plan.iterations : 4;
    if (plan.stepper == scenes::Stepper::kFast) return scenes::step_fast(world, h, substeps);
    if (plan.stepper == scenes::Stepper::kHybrid) return scenes::step_hybrid(world, h, substeps);
    if (plan.iterations > 0) dWorldSetQuickStepNumIterations(world, plan.iterations);
    return dWorldQuickStep(world, h);
}

// A world whose contacts were the program's has nobody to make them here: its geoms touch by themselves.
int carry_out(const RunOptions& options, const RunPlan& plan)
{
    scenes::Runtime runtime;
    scenes::MessageCounter messages;
    const LoadedWorld loaded(options.scene);
    if (!loaded) return complain(options.scene, "cannot be loaded");
    if (loaded.space() && !scenes::contact_space(loaded.world()))
        scenes::set_contact_space(loaded.world(), loaded.space());
    if (plan.threads > 1) scenes::set_step_threads(loaded.world(), plan.threads);
    const auto begin = std::chrono::steady_clock::now();
    int steps = 0, made = 1;
    while (steps < plan.steps && made && !interruption()) made = step(loaded.world(), plan), ++steps;
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    const Motion motion = motion_of(loaded.world());
    FieldList fields;
    put_counts(fields, options.scene, loaded);
    fields.string("stepper", scenes::name_of(plan.stepper), "stepper", scenes::name_of(plan.stepper));
    fields.number("steps", steps, "steps", fmt::format("{} of {:g} s", steps, plan.dt));
    fields.number("step_ms", time.count() / steps, "a step", fmt::format("{:.3g} ms", time.count() / steps));
    fields.number("max_speed", motion.max_speed, "fastest body", fmt::format("{:.3g} m/s", motion.max_speed));
    fields.number("nans", motion.not_finite);
    fields.number("messages", messages.count());
    put(options.json ? as_json(fields.take()) : as_table(fields.take()));
    if (motion.not_finite > 0) warn("{} bodies are not finite", motion.not_finite);
    if (!made) warn("the library reports that the step failed");
    return made && motion.not_finite == 0 ? kFine : kProblem;
}

}  // namespace

bool is_world_file(const std::string& name) { return name.ends_with(kEnding); }

int save_scene(const RunOptions& options, const std::string& path)
{
    const scenes::Recipe* recipe = scenes::find_recipe(options.scene);
    if (!recipe) return refuse(no_such_scene(options.scene));
    if (!scenes::has_world_files()) return refuse(no_files());
    if (!is_world_file(path))
        return refuse(fmt::format("'{}' does not end with {}, as files of worlds do", path, kEnding));
    RunPlan plan;
    std::string problem;
    if (!settle(options, *recipe, plan, problem)) return refuse(problem);
    if (!can_write(path, problem)) return complain(path, problem);
    scenes::Runtime runtime;
    scenes::MessageCounter messages;
    scenes::Scene scene(*recipe, plan.seed);
    if (!set_up(scene, plan, problem)) return refuse(problem);
    for (int i = 0; i < plan.steps; ++i)
        if (interruption() || !scene.step(plan.stepper, plan.dt))
            return complain(path, "the run ended early");
    if (!scenes::save_world(scene.world(), scene.space(), path)) return complain(path, "cannot be written");
    if (!options.quiet) say("{}: {} after {:g} s\n", path, options.scene, plan.steps * plan.dt);
    return kFine;
}

int run_world_file(const RunOptions& options)
{
    if (!scenes::has_world_files()) return refuse(no_files());
    if (!options.picture.empty() || !options.trace.empty() || !options.video.empty() ||
        !options.records.empty() || options.diagnose)
        return refuse("--picture, --trace, --record, --video, --html and --diagnose are for scenes");
    static const scenes::Recipe kRecipe = {"file", "", 1.0 / 60, 5, scenes::Stepper::kQuick, nullptr};
    RunPlan plan;
    std::string problem;
    return settle(options, kRecipe, plan, problem) ? carry_out(options, plan) : refuse(problem);
}

int describe_world_file(const std::string& path, bool json)
{
    if (!scenes::has_world_files()) return refuse(no_files());
    scenes::Runtime runtime;
    scenes::MessageCounter messages;
    const LoadedWorld loaded(path);
    if (!loaded) return complain(path, "cannot be loaded");
    FieldList fields;
    put_counts(fields, path, loaded);
    put(json ? as_json(fields.take()) : as_table(fields.take()));
    return kFine;
}

}  // namespace epode::cli
