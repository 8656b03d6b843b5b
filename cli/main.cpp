// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// epode: simulates a named scene, judges the result, shows a picture. This file is the command line alone.
#include <sys/stat.h>
#include <CLI/CLI.hpp>

#include <exception>
#include <new>
#include <sstream>

#include "cli/capture.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/numbers.h"
#include "cli/replay.h"
#include "cli/robot.h"
#include "cli/run.h"
#include "cli/suggest.h"
#include "cli/view.h"
#include "cli/world_file.h"
#include "scenes/extensions.h"

namespace {

using epode::cli::CaptureOptions;
using epode::cli::number_within;
using epode::cli::ReplayOptions;
using epode::cli::RunOptions;
using epode::cli::whole_number_within;

// A device has the name that it has, which says of no format: it is refused.
std::string with_ending(const std::string& path, const std::string& ending)
{
    struct stat status;
    if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) return path;
    const bool has = path.size() > ending.size() && path.ends_with(ending);
    return has ? path : path + ending;
}

// What is stepped and how.
void add_plan_options(CLI::App& command, RunOptions& options)
{
    const CLI::Validator positive = number_within(1e-9, 1e9);
    command
        .add_option("scene", options.scene,
                    "one of `epode list`, or a robot (.urdf, .xml, .sdf); for run also a world (.epw)")
        ->required();
    command.add_option("--stepper", options.stepper,
                       "exact, quick, fast or hybrid; default: as the guide recommends, which is exact for "
                       "mechanisms and, for scenes of many bodies as in games, fast with --world-contacts");
    command.add_flag("--world-contacts", options.world_contacts,
                     "world-managed contacts instead of contact joints from a callback; without "
                     "--stepper that is the default for scenes of many bodies");
    command.add_option("--threads", options.threads, "threads of a step (default 1), with the same results")
        ->check(whole_number_within(1, epode::cli::kMaxThreads));
    command.add_option("--dt", options.dt, "step size in seconds; default: the scene's own")->check(positive);
    auto* steps = command.add_option("--steps", options.steps, "number of steps")
                      ->check(whole_number_within(1, 100'000'000));
    auto* seconds =
        command.add_option("--seconds", options.seconds, "simulated time; default: the scene's own")
            ->check(positive);
    steps->excludes(seconds);
    command
        .add_option("--iterations", options.iterations,
                    "sweeps of quick (default 20), substeps of fast and hybrid (default 4)")
        ->check(whole_number_within(1, epode::cli::kMaxIterations));
    command.add_option("--seed", options.seed, "of the scenes that are poured at random (default 1)");
    command.add_flag("--json", options.json, "report as one JSON object");
    command.add_flag("--quiet", options.quiet, "no progress on stderr");
}

void add_run_options(CLI::App& command, RunOptions& options)
{
    add_plan_options(command, options);
    command.add_flag("--diagnose", options.diagnose,
                     "why it went wrong: the first three causes, with remedies");
    command.add_option("--picture", options.picture, "PNG file of the last state");
    command.add_option("--trace", options.trace, "CSV file, one line per step");
    command
        .add_option("--record", options.records,
                    "recording: .epr (all there is), .glb (animation), .html (page) or .csv; may be repeated")
        ->allow_extra_args(false);
    command.add_option("--video", options.video, "video (.mp4) by ffmpeg; PNG files where there is none");
    command.add_option_function<std::string>(
        "--html",
        [&options](const std::string& path) { options.records.push_back(with_ending(path, ".html")); },
        "replay page: one file for any browser; the same as --record FILE.html");
}

void add_record_options(CLI::App& command, RunOptions& options)
{
    add_plan_options(command, options);
    command.add_option("-o,--output", options.records, "recording to write, as for run --record")
        ->required()
        ->allow_extra_args(false);
}

void add_fps(CLI::App& command, double& fps)
{
    command.add_option("--fps", fps, "pictures a second of animations (default 30)")
        ->check(number_within(0.1, 1000.0));
}

void add_replay_options(CLI::App& command, ReplayOptions& options)
{
    command.add_option("file", options.file, "recording (.epr)")->required();
    command.add_option(
        "--stepper", options.stepper,
        "step with another stepper (exact, quick, fast, hybrid) and tell how far apart they go");
    command.add_option("--iterations", options.iterations, "another number of them, likewise")
        ->check(whole_number_within(1, epode::cli::kMaxIterations));
    command
        .add_option("--contacts", options.contacts,
                    "of a captured program: recorded, or found again (default with another stepper)")
        ->check(CLI::IsMember({"recorded", "found"}));
    command.add_option("-o,--output", options.output,
                       "of a captured program: recording (.epr) of the new run");
}

void add_capture_options(CLI::App& command, CaptureOptions& options)
{
    command
        .add_option("-o,--output", options.output, "recording to write (.epr); further worlds get -2, -3 ...")
        ->required();
    command.add_option("--stepper", options.stepper,
                       "exact, quick, fast or hybrid, whatever the program calls");
    command.add_flag("--quiet", options.quiet, "do not say what was recorded");
    command.add_option("program", options.command, "program and arguments, after --")->required();
    command.positionals_at_end();
}

void add_common_options(CLI::App& command, ReplayOptions& options)
{
    command.add_flag("--partial", options.partial, "take what there is of a recording that breaks off");
    command.add_flag("--json", options.json, "report as one JSON object");
    command.add_flag("--quiet", options.quiet, "no progress on stderr");
}

std::string version()
{
    return fmt::format("epode {} ({} precision), with {} {}: {}", EPODE_VERSION,
                       sizeof(dReal) == 8 ? "double" : "single", epode::scenes::loaded_library_kind(),
                       epode::scenes::loaded_library(), dGetConfiguration());
}

// Every name of an option that a command takes.
std::vector<std::string> option_names(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

// What may have been meant by the first word that is none: a verb, else an option. "" where all words are
// known.
std::string suggestion(const CLI::App& app, int argc, char** argv)
{
    std::vector<std::string> verbs;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        verbs.push_back(command->get_name());
    const CLI::App* command = &app;
    for (int i = 1; i < argc && std::string(argv[i]) != "--"; ++i) {
        const std::string word = argv[i], name = word.substr(0, word.find('='));
        const bool is_verb = std::find(verbs.begin(), verbs.end(), word) != verbs.end();
        if (command == &app && is_verb) {
            command = app.get_subcommand(word);
        } else if (command == &app && word[0] != '-') {
            return epode::cli::did_you_mean(word, verbs);
        } else if (word.starts_with("--")) {
            const std::vector<std::string> names = option_names(*command);
            const bool known = std::find(names.begin(), names.end(), name) != names.end();
            if (!known) return epode::cli::did_you_mean(name, names);
        }
    }
    return {};
}

// Help and the version are printed like everything else, so that a full disk shows.
int print_usage(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv)
{
    if (error.get_exit_code() != 0) {
        const std::string meant = suggestion(app, argc, argv);
        return epode::cli::refuse(std::string(error.what()) + "." + meant +
                                  "\nRun with --help for more information.");
    }
    std::ostringstream text, nothing;
    app.exit(error, text, nothing);
    epode::cli::put(text.str());
    return epode::cli::kFine;
}

int carry_out(int argc, char** argv)
{
    CLI::App app("Simulates a scene with the ODE interface, judges the result, shows a picture.", "epode");
    app.require_subcommand(1);
    app.set_version_flag("--version", version, "this program's version, its library and how that was built");
    app.footer(
        "Exit codes: 0 fine, 1 a problem was found or a file cannot be written, 2 wrong usage, 128 + n ended "
        "by signal n with all files whole.");
    CLI::App* list = app.add_subcommand("list", "names the scenes");
    CLI::App* run = app.add_subcommand("run", "runs a scene and reports");
    CLI::App* record = app.add_subcommand("record", "runs a scene into a recording");
    CLI::App* view =
        app.add_subcommand("view", "shows a scene or a recording in a window, to be played with");
    CLI::App* replay =
        app.add_subcommand("replay", "runs a recorded scene or program again and compares, step by step");
    CLI::App* diff =
        app.add_subcommand("diff", "finds the first step and body in which two recordings differ");
    CLI::App* convert = app.add_subcommand("convert", "writes a recording in another format");
    CLI::App* inspect = app.add_subcommand("inspect", "says what is in a recording");
    CLI::App* capture = app.add_subcommand("capture", "runs any ODE program and records its worlds");
    CLI::App* save = app.add_subcommand("save", "runs a scene and saves its world to a file");
    CLI::App* info = app.add_subcommand("info", "says what is in a file of a world");
    RunOptions options;
    std::string world_file;
    add_run_options(*run, options);
    add_plan_options(*save, options);
    save->add_option("file", world_file, "file to write (.epw)")->required();
    info->add_option("file", world_file, "file of a world (.epw)")->required();
    info->add_flag("--json", options.json, "as one JSON object");
    add_record_options(*record, options);
    ReplayOptions replaying;
    for (CLI::App* command : {run, record}) add_fps(*command, options.fps);
    add_fps(*convert, replaying.fps);
    add_replay_options(*replay, replaying);
    diff->add_option("a", replaying.file, "recording (.epr)")->required();
    diff->add_option("b", replaying.other, "recording (.epr)")->required();
    convert->add_option("file", replaying.file, "recording (.epr)")->required();
    convert->add_option("to", replaying.other, "file to write")->required();
    inspect->add_option("file", replaying.file, "recording (.epr)")->required();
    inspect->add_flag("--hashes", replaying.hashes, "number and hash of every state, a line each");
    epode::view::ViewOptions viewing;
    epode::cli::add_view_options(*view, viewing);
    epode::cli::RobotOptions robot_options;
    CLI::App* robot = app.add_subcommand(
        "robot", "says what is in a robot's file and what is wrong with it; converts it; shows it");
    epode::cli::add_robot_options(*robot, robot_options, viewing);
    CaptureOptions capturing;
    add_capture_options(*capture, capturing);
    for (CLI::App* command : {replay, diff, convert, inspect}) add_common_options(*command, replaying);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return print_usage(app, error, argc, argv);
    }
    if (robot->parsed() && !robot_options.is_viewed) return epode::cli::run_robot(robot_options);
    std::string problem;
    const bool shows = view->parsed() || robot_options.is_viewed;
    const std::string& what = shows ? viewing.what : options.scene;
    if (!epode::cli::offer_robot(what, robot_options.is_viewed, problem))
        return epode::cli::complain(what, problem);
    if (list->parsed()) return epode::cli::list_scenes();
    if (shows) return epode::cli::view(viewing);
    if (replay->parsed()) return epode::cli::replay(replaying);
    if (diff->parsed()) return epode::cli::diff(replaying);
    if (convert->parsed()) return epode::cli::convert(replaying);
    if (inspect->parsed()) return epode::cli::inspect(replaying);
    if (capture->parsed()) return epode::cli::capture(capturing);
    if (save->parsed()) return epode::cli::save_scene(options, world_file);
    if (info->parsed()) return epode::cli::describe_world_file(world_file, options.json);
    return epode::cli::is_world_file(options.scene) ? epode::cli::run_world_file(options)
                                                    : epode::cli::run(options);
}

// What is thrown is a bug or the lack of memory; either is a problem and no crash.
int guarded(int argc, char** argv)
{
    try {
        return carry_out(argc, argv);
    } catch (const std::bad_alloc&) {
        epode::cli::warn("there is not enough memory");
    } catch (const std::exception& error) {
        epode::cli::warn("{}", error.what());
    }
    return epode::cli::kProblem;
}

}  // namespace

int epode::cli::run_command(int argc, char** argv)
{
    // `epode view` writes its status as it goes and ends with its reader.
    const bool viewing =
        argc > 1 && (std::string(argv[1]) == "view" ||
                     (argc > 2 && std::string(argv[1]) == "robot" && std::string(argv[2]) == "view"));
    open_console(!viewing);
    return finish_console(guarded(argc, argv));
}
