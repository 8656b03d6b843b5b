// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// epode_bench: times scenes on whichever libode.so.8 the loader finds, and says which it was. bench/compare
// runs it on two of them in turn.
#include <CLI/CLI.hpp>

#include "bench/collision/mesh_rays.h"
#include "bench/collision/pairs.h"
#include "bench/collision/space_table.h"
#include "bench/collision/spaces.h"
#include "bench/collision/terrain.h"
#include "bench/problems/exact_table.h"
#include "bench/problems/mechanisms.h"
#include "bench/problems/pile.h"
#include "bench/runs/asleep.h"
#include "bench/runs/hybrid.h"
#include "bench/runs/loaded_robot.h"
#include "bench/runs/scene_bench.h"
#include "bench/runs/scene_run.h"
#include "bench/runs/state.h"
#include "bench/runs/worlds.h"
#include "bench/truth/accuracy.h"
#include "scenes/extensions.h"

namespace {

// Subcommands besides the names of scenes.
CLI::App* add_exact_table(CLI::App& app, epode::bench::TableOptions& options)
{
    CLI::App* command = app.add_subcommand("exact-table", "dWorldStep on the problems of bench/exact");
    command->add_option("--problem", options.problem, "one of them; default: all");
    command->add_option("--velocities", options.velocities,
                        "write the velocities after one step to this file");
    command->add_option("--seconds", options.seconds, "time to spend on timing a problem (default 0.3)");
    command->add_option("--steps", options.steps, "steps to time at most (default 2000)")
        ->check(CLI::Range(1, 10'000'000));
    command
        ->add_option("--untimed", options.untimed, "only take the steps of one problem, from these impulses")
        ->check(CLI::IsMember({"warm", "cold"}));
    return command;
}

struct AccuracyArguments {
    epode::bench::AccuracyOptions options;
    std::string stepper = "exact";
};

CLI::App* add_accuracy(CLI::App& app, AccuracyArguments& arguments)
{
    CLI::App* command = app.add_subcommand("accuracy", "one run of a test of bench/accuracy");
    command->add_option("test", arguments.options.test, "rolling, bouncing, 666, elastic-666, grasp or whip")
        ->required();
    command->add_option("--stepper", arguments.stepper, "exact, quick or fast (default exact)");
    command->add_option("--dt", arguments.options.dt, "step size in seconds (default 0.001)")
        ->check(CLI::Range(1e-6, 1.0));
    command->add_option("--variant", arguments.options.variant,
                        "rolling: y, xy, xy-fdir; whip: plain, projected, nudged1, nudged2, ...");
    command->add_option("--trace", arguments.options.trace,
                        "whip: write the gap after every step to this file");
    command->add_option("--size", arguments.options.size,
                        "grasp: load in N; whip: end mass in links; others: iterations");
    return command;
}

struct PileOptions {
    int count = 20, rows = 264;
    double side = 2;
    std::uint32_t seed = 1;
};

CLI::App* add_make_pile(CLI::App& app, PileOptions& options)
{
    CLI::App* command = app.add_subcommand("make-pile", "drop boxes, print a file for bench/data");
    command->add_option("--count", options.count, "boxes (default 20)")->check(CLI::Range(1, 10'000));
    command->add_option("--side", options.side, "of the area they fall on, m (default 2)");
    command->add_option("--rows", options.rows, "rows at which they are caught (default 264)");
    command->add_option("--seed", options.seed, "default 1");
    return command;
}

CLI::App* add_mesh_rays(CLI::App& app, epode::bench::MeshRayOptions& options)
{
    CLI::App* command = app.add_subcommand("mesh-rays", "rays against a mesh, as bench/rays runs it");
    command->add_option("--mesh", options.mesh, "terrain, ball or soup (default terrain)")
        ->check(CLI::IsMember({"terrain", "ball", "soup"}));
    command->add_option("--triangles", options.triangles, "about so many (default 100000)")
        ->check(CLI::Range(1, 10'000'000));
    command->add_option("--rays", options.rays, "default 100000")->check(CLI::Range(1, 100'000'000));
    command->add_option("--repeat", options.repeat, "runs, of which the least time counts (default 3)")
        ->check(CLI::Range(1, 1000));
    return command;
}

CLI::App* add_terrain(CLI::App& app, epode::bench::TerrainOptions& options)
{
    CLI::App* command =
        app.add_subcommand("terrain", "dCollide of solids with a landscape of 131,072 triangles");
    command->add_option("--cells", options.cells, "to a side (default 256)")->check(CLI::Range(1, 4096));
    command->add_option("--solids", options.solids, "of each class (default 2000)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--rounds", options.rounds, "the quickest counts (default 5)")
        ->check(CLI::Range(1, 10'000));
    command->add_flag("--field", options.field, "as a height field, not as a mesh");
    command->add_option("--only", options.only, "sphere, box, capsule or cylinder")
        ->check(CLI::IsMember({"sphere", "box", "capsule", "cylinder"}));
    return command;
}

CLI::App* add_spaces(CLI::App& app, epode::bench::SpaceOptions& options)
{
    CLI::App* command =
        app.add_subcommand("spaces", "rays at boxes and boxes on the move, as bench/spaces runs it");
    command->add_option("--space", options.space, "hash, quadtree or sap (default hash)")
        ->check(CLI::IsMember({"hash", "quadtree", "sap"}));
    command->add_option("--boxes", options.boxes, "that rays are cast at (default 8000)")
        ->check(CLI::Range(1, 10'000'000));
    command->add_option("--rays", options.rays, "default 2000")->check(CLI::Range(1, 10'000'000));
    command->add_option("--moving", options.moving, "boxes (default 20000)")
        ->check(CLI::Range(1, 10'000'000));
    command->add_option("--steps", options.steps, "default 20")->check(CLI::Range(1, 1'000'000));
    return command;
}

CLI::App* add_worlds(CLI::App& app, epode::bench::WorldsOptions& options)
{
    CLI::App* command =
        app.add_subcommand("worlds", "many small worlds: a loop of single steps against dWorldsStep");
    command->add_option("--scene", options.scene, "one of `epode_bench scenes` (default S4)");
    command->add_option("--size", options.size, "of the scene (default 1)")->check(CLI::Range(1, 100'000));
    command->add_option("--worlds", options.worlds, "default 64")->check(CLI::Range(1, 100'000));
    command->add_option("--steps", options.steps, "of each world in a round (default 20)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--rounds", options.rounds, "the quickest counts (default 15)")
        ->check(CLI::Range(1, 10'000));
    command->add_option("--stepper", options.stepper, "exact, quick or fast (default fast)")
        ->check(CLI::IsMember({"exact", "quick", "fast"}));
    return command;
}

CLI::App* add_mechanisms(CLI::App& app, epode::bench::MechanismOptions& options)
{
    CLI::App* command = app.add_subcommand("mechanisms", "a step of many robots, as bench/robots runs it");
    command->add_option("--model", options.model, "ant, half-cheetah, humanoid, free-body, box or chain");
    command->add_option("--stepper", options.stepper, "exact, quick or fast (default exact)")
        ->check(CLI::IsMember({"exact", "quick", "fast"}));
    command->add_option("--worlds", options.worlds, "default 64")->check(CLI::Range(1, 100'000));
    command->add_option("--threads", options.threads, "default 1")->check(CLI::Range(1, 64));
    command->add_option("--projection", options.projection, "Newton steps on positions (default 0)")
        ->check(CLI::Range(0, 100));
    command->add_option("--settle", options.settle, "steps before the first that is timed (default 50)")
        ->check(CLI::Range(0, 1'000'000));
    command->add_option("--steps", options.steps, "of each world in a round (default 500)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--rounds", options.rounds, "the quickest counts (default 3)")
        ->check(CLI::Range(1, 10'000));
    return command;
}

CLI::App* add_state(CLI::App& app, epode::bench::StateOptions& options)
{
    CLI::App* command = app.add_subcommand("state", "states of a pile of boxes: bytes, saving and restoring");
    command->add_option("--boxes", options.boxes, "of the heap (default 1000)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--steps", options.steps, "before the first is timed (default 300)")
        ->check(CLI::Range(0, 1'000'000));
    command->add_option("--rounds", options.rounds, "that are timed (default 50)")
        ->check(CLI::Range(1, 100'000));
    command->add_flag("--sleep", options.sleeps, "boxes may fall asleep");
    return command;
}

CLI::App* add_asleep(CLI::App& app, epode::bench::AsleepOptions& options)
{
    CLI::App* command = app.add_subcommand("asleep", "steps of a world of which most sleeps");
    command->add_option("--boxes", options.boxes, "asleep (default 20000)")->check(CLI::Range(4, 1'000'000));
    command->add_option("--awake", options.awake, "balls (default 100)")->check(CLI::Range(0, 1'000'000));
    command->add_option("--steps", options.steps, "that are timed (default 100)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_flag("--no-space", options.no_space, "without contacts");
    return command;
}

CLI::App* add_hybrid(CLI::App& app, epode::bench::HybridOptions& options)
{
    CLI::App* command = app.add_subcommand("hybrid", "hybrid steps compared with substeps: worst steps");
    command->add_option("--steps", options.steps, "that are timed (default 300)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_flag("--large", options.large, "10,000 pieces of debris, too");
    command->add_option("--only", options.only, "hybrid steps of this world alone");
    command->add_option("--size", options.size, "of it (default: its own)")->check(CLI::Range(1, 1'000'000));
    return command;
}

CLI::App* add_robot(CLI::App& app, epode::bench::LoadedRobotOptions& options)
{
    CLI::App* command = app.add_subcommand("robot", "steps of a robot's file in the robot preset");
    command->add_option("file", options.file, "URDF or MJCF")->required();
    command->add_option("--steps", options.steps, "that are timed (default 1000)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_flag("--no-quality", options.no_quality, "times alone");
    command->add_option("--h", options.h, "size of a step, s (default 0.002)")->check(CLI::Range(1e-6, 1.0));
    return command;
}

// Of benchmark scenes: run, export, judge.
void add_scene_choice(CLI::App& command, epode::bench::SceneChoice& choice)
{
    command.add_option("scene", choice.name, "one of `epode_bench scenes`")->required();
    command.add_flag("--quick", choice.quick, "the small and short setting");
    command.add_option("--size", choice.size, "another size")->check(CLI::Range(1, 10'000'000));
    command.add_option("--steps", choice.steps, "another length")->check(CLI::Range(1, 10'000'000));
}

CLI::App* add_run(CLI::App& app, epode::bench::SceneRunOptions& options)
{
    CLI::App* command = app.add_subcommand("run", "one engine on one benchmark scene, as JSON");
    add_scene_choice(*command, options.scene);
    epode::bench::EngineOptions& engine = options.engine;
    command->add_option("--engine", options.engine_name, "one of `epode_bench engines` (default ode)");
    command->add_option("--iterations", engine.iterations, "of its solver; default: its own")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--threads", engine.threads, "default 1; time is then that of the wall")
        ->check(CLI::Range(1, 1024));
    command
        ->add_option("--stepper", engine.stepper, "of ODE; default: the scene's own; joints: of hybrid only")
        ->check(CLI::IsMember({"exact", "joints", "quick", "fast"}));
    command->add_option("--space", engine.space, "of ODE (default hash)")
        ->check(CLI::IsMember({"hash", "quadtree", "sap"}));
    command->add_option("--contacts", engine.contacts, "of ODE, at most of a pair (default 8)")
        ->check(CLI::Range(1, 64));
    command->add_flag("--manifold-friction", engine.manifold_friction,
                      "of managed and hybrid: one friction for the points of two geoms");
    command->add_flag("!--no-quality", options.judged, "only the time");
    command->add_flag("--memory", options.memory, "also bytes that a libode takes");
    return command;
}

CLI::App* add_export(CLI::App& app, epode::bench::SceneChoice& choice)
{
    CLI::App* command = app.add_subcommand("export", "a benchmark scene as JSON");
    add_scene_choice(*command, choice);
    return command;
}

struct JudgeArguments {
    epode::bench::SceneChoice choice;
    std::string file;
};

CLI::App* add_judge(CLI::App& app, JudgeArguments& arguments)
{
    CLI::App* command = app.add_subcommand("judge", "the quality of states that another program has written");
    add_scene_choice(*command, arguments.choice);
    command->add_option("file", arguments.file, "lines `state STEP`, then 13 numbers a body")->required();
    return command;
}

int print_engines()
{
    for (const epode::bench::EngineEntry* engine : epode::bench::engine_entries())
        std::printf("%s: %s\n", engine->name, engine->about);
    return 0;
}

CLI::App* add_pairs(CLI::App& app, epode::bench::PairOptions& options)
{
    CLI::App* command = app.add_subcommand("pairs", "dCollide pair by pair, as bench/collide runs it");
    command->add_option("--first", options.first, "only pairs with this member");
    command->add_option("--second", options.second, "and this one");
    command->add_option("--set", options.set, "only these poses: resting, tumbled or apart")
        ->check(CLI::IsMember({"resting", "tumbled", "apart"}));
    command->add_option("--poses", options.poses, "of each set (default 500)")->check(CLI::Range(1, 100'000));
    command->add_option("--rounds", options.rounds, "the quickest counts (default 5)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_flag("--listed", options.listed,
                      "those that standard input lists, as bench/collide --table asks");
    return command;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Times a scene: median, p10, p90 in ms per step, its parts, and the quality of the result.",
                 "epode_bench");
    epode::bench::SceneOptions options;
    app.add_option("scene", options.scene, "a scene of `epode list`");
    app.add_option("--stepper", options.stepper, "exact, quick or fast; default: the scene's own");
    app.add_option("--dt", options.dt, "step size in seconds; default: the scene's own")
        ->check(CLI::Range(1e-9, 1e9));
    app.add_option("--steps", options.steps, "number of steps; default: the scene's own")
        ->check(CLI::Range(1, 10'000'000));
    app.add_option("--repeat", options.repeat, "runs, each from a fresh start (default 3)")
        ->check(CLI::Range(1, 10'000));
    app.add_option("--iterations", options.iterations,
                   "sweeps of quick (default 20), substeps of fast (default 4)")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--seed", options.seed, "of scenes that are poured at random (default 1)");
    app.add_flag("--json", options.json, "print JSON");
    epode::bench::TableOptions table;
    CLI::App* exact_table = add_exact_table(app, table);
    AccuracyArguments accuracy;
    CLI::App* accuracy_test = add_accuracy(app, accuracy);
    PileOptions pile;
    CLI::App* make_pile = add_make_pile(app, pile);
    epode::bench::MeshRayOptions rays;
    CLI::App* mesh_rays = add_mesh_rays(app, rays);
    epode::bench::TerrainOptions terrain;
    CLI::App* terrain_command = add_terrain(app, terrain);
    epode::bench::PairOptions pairs;
    CLI::App* pairs_command = add_pairs(app, pairs);
    epode::bench::SpaceOptions spaces;
    CLI::App* spaces_command = add_spaces(app, spaces);
    CLI::App* space_table = app.add_subcommand("space-table", "what programs ask of each kind of space");
    epode::bench::WorldsOptions worlds;
    CLI::App* worlds_command = add_worlds(app, worlds);
    epode::bench::MechanismOptions mechanisms;
    CLI::App* mechanisms_command = add_mechanisms(app, mechanisms);
    epode::bench::StateOptions state;
    CLI::App* state_command = add_state(app, state);
    epode::bench::AsleepOptions asleep;
    CLI::App* asleep_command = add_asleep(app, asleep);
    epode::bench::HybridOptions hybrid;
    CLI::App* hybrid_command = add_hybrid(app, hybrid);
    epode::bench::LoadedRobotOptions robot;
    CLI::App* robot_command = add_robot(app, robot);
    epode::bench::SceneRunOptions run;
    CLI::App* run_command = add_run(app, run);
    epode::bench::SceneChoice exported;
    CLI::App* export_command = add_export(app, exported);
    JudgeArguments judged;
    CLI::App* judge_command = add_judge(app, judged);
    CLI::App* scenes_command = app.add_subcommand("scenes", "list the benchmark scenes");
    CLI::App* engines_command = app.add_subcommand("engines", "list the engines of this build");
    CLI::App* library = app.add_subcommand("library", "print the file of the libode at hand");
    app.require_subcommand(0, 1);
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty() && options.scene.empty()) throw CLI::RequiredError("scene");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }

    epode::scenes::Runtime runtime;
    if (*library) {
        std::puts(epode::scenes::loaded_library().c_str());
        return 0;
    }
    if (*run_command) return epode::bench::run_scene(run);
    if (*export_command) return epode::bench::export_scene(exported);
    if (*judge_command) return epode::bench::judge_file(judged.choice, judged.file);
    if (*scenes_command) return epode::bench::list_scenes();
    if (*engines_command) return print_engines();
    if (*exact_table) return epode::bench::bench_exact_table(table);
    if (*accuracy_test) {
        if (!epode::scenes::stepper_named(accuracy.stepper, accuracy.options.stepper)) {
            std::fputs("epode_bench: steppers are exact, quick and fast\n", stderr);
            return 2;
        }
        return epode::bench::bench_accuracy(accuracy.options);
    }
    if (*mesh_rays) return epode::bench::bench_mesh_rays(rays);
    if (*terrain_command) return epode::bench::bench_terrain(terrain);
    if (*pairs_command)
        return pairs.listed ? epode::bench::bench_listed_pairs(pairs.poses)
                            : epode::bench::bench_pairs(pairs);
    if (*spaces_command) return epode::bench::bench_spaces(spaces);
    if (*space_table) return epode::bench::bench_space_table();
    if (*worlds_command) return epode::bench::bench_worlds(worlds);
    if (*mechanisms_command) return epode::bench::bench_mechanisms(mechanisms);
    if (*state_command) return epode::bench::bench_state(state);
    if (*asleep_command) return epode::bench::bench_asleep(asleep);
    if (*hybrid_command) return epode::bench::bench_hybrid(hybrid);
    if (*robot_command) return epode::bench::bench_loaded_robot(robot);
    if (*make_pile) return epode::bench::print_pile(pile.count, pile.side, pile.rows, pile.seed);
    return epode::bench::bench_scene(options);
}
