// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Scenes in settings, judged by their laws (trial.h).
//   trials list                          scenes, laws and bounds
//   trials run [WHAT...]                 figures of the cells
//   trials check [WHAT...]               faults compared with known.tsv; exit status 1 if there are any
//   trials rank [WHAT...]                cells that fail, presets first, the worst first
// WHAT: names of scenes, methods ("ode exact"), step sizes ("1/60", "1 ms"), "sleep" or "awake"; without any, all.
//   --quick            the cells that ctest checks
//   --jobs N           processes at a time (one for each processor)
//   --seconds N        of CPU that a cell may take (60)
//   --json FILE        writes the results
//   --from FILE        reads them instead of running
//   --write FILE       writes the tables: docs/quality.md
//   --known FILE       another known.tsv
//   --accept           writes known.tsv as the results are
#include "pool.h"
#include "table.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace epode::trials {
namespace {

struct Options {
    std::string command, json, from, write, known = EPODE_TRIALS_KNOWN;
    std::vector<std::string> scenes, methods, step_sizes, sleeps;  // empty: all
    bool quick = false, accept = false;
    PoolOptions pool;
};

bool is_among(const std::vector<std::string>& words, const std::string& word)
{
    return words.empty() || std::find(words.begin(), words.end(), word) != words.end();
}

const char* name_of_sleep(bool sleep) { return sleep ? "sleep" : "awake"; }

// The list that a word belongs to.
std::vector<std::string>& list_for(Options& options, const std::string& word)
{
    if (scene_named(word)) return options.scenes;
    for (const Setting& setting : all_settings()) {
        if (word == name_of(setting.method)) return options.methods;
        if (word == name_of_step(setting.step_size)) return options.step_sizes;
        if (word == name_of_sleep(setting.sleep)) return options.sleeps;
    }
    throw std::runtime_error("unknown: '" + word + "'; `trials list` names the scenes");
}

Options read(int argc, char** argv)
{
    Options options;
    const auto value = [&](int& i) {
        if (++i >= argc) throw std::runtime_error(std::string(argv[i - 1]) + " needs a value");
        return std::string(argv[i]);
    };
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--quick")
            options.quick = true;
        else if (word == "--accept")
            options.accept = true;
        else if (word == "--jobs")
            options.pool.jobs = std::stoi(value(i));
        else if (word == "--seconds")
            options.pool.seconds = std::stoi(value(i));
        else if (word == "--json")
            options.json = value(i);
        else if (word == "--from")
            options.from = value(i);
        else if (word == "--write")
            options.write = value(i);
        else if (word == "--known")
            options.known = value(i);
        else if (options.command.empty())
            options.command = word;
        else
            list_for(options, word).push_back(word);
    }
    return options;
}

bool wanted(const Options& options, const Scene& scene, const Setting& setting)
{
    if (!is_among(options.scenes, scene.name)) return false;
    if (scene.one_setting) return setting == Setting{};
    if (options.quick && !is_quick(scene, setting)) return false;
    return is_among(options.methods, name_of(setting.method)) &&
           is_among(options.step_sizes, name_of_step(setting.step_size)) &&
           is_among(options.sleeps, name_of_sleep(setting.sleep));
}

std::vector<Result> results_of(Options options)
{
    std::vector<Result> results;
    if (!options.from.empty()) {
        for (const Result& result : read_json(options.from))
            if (wanted(options, *result.cell.scene, result.cell.setting)) results.push_back(result);
        return results;
    }
    std::vector<Cell> cells;
    for (const Scene* scene : all_scenes())
        for (const Setting& setting : all_settings())
            if (wanted(options, *scene, setting)) cells.push_back({scene, setting});
    return run_cells(cells, options.pool);
}

void list()
{
    for (const Scene* scene : all_scenes()) {
        std::printf("%-20s %s\n", scene->name, scene->title);
        for (const Law& law : scene->laws)
            std::printf("    %-16s %s: at most %g %s\n", law.name, law.text, law.bound({}), law.unit);
    }
}

void print(const Result& result)
{
    std::printf("%s, %s (%.2f s)%s\n", result.cell.scene->name, text_of(result.cell.setting).c_str(),
                result.seconds,
                result.ending == Ending::kTime    ? ": took too long"
                : result.ending == Ending::kCrash ? ": crashed"
                                                  : "");
    if (result.ending == Ending::kDone)
        for (const Law& law : result.cell.scene->laws)
            std::printf("    %-16s %10.4g %-6s at most %-8.3g %s\n", law.name, result.figure(law), law.unit,
                        law.kept(result.cell.setting),
                        result.figure(law) > law.kept(result.cell.setting) ? "FAILS" : "");
    std::fflush(stdout);
}

int check(const std::vector<Result>& results, const Known& known)
{
    int faults = 0;
    for (const Result& result : results) {
        for (const Law& law : result.cell.scene->laws) {
            const std::string fault = fault_of(known, result, law);
            if (fault.empty()) continue;
            std::printf("%s\n", fault.c_str());
            ++faults;
        }
    }
    std::printf("%zu cells, %d faults\n", results.size(), faults);
    return faults > 0;
}

int run(Options options)
{
    if (options.command == "list") return list(), 0;
    const bool known_command =
        options.command == "run" || options.command == "check" || options.command == "rank";
    if (!known_command)
        throw std::runtime_error("commands are list, run, check and rank (tests/trials/main.cpp)");
    if (options.command == "run") options.pool.done = &print;
    const std::vector<Result> results = results_of(options);
    const Known known(options.known);
    if (!options.json.empty()) write_json(results, options.json);
    if (options.accept) known.write(results, options.known);
    if (!options.write.empty()) {
        std::ofstream page(options.write);
        page << quality_page(results, Known(options.known));
        if (!page) throw std::runtime_error(options.write + ": cannot be written");
    }
    if (options.command == "rank") std::fputs(ranking(results, known).c_str(), stdout);
    return options.command == "check" ? check(results, known) : 0;
}

}  // namespace
}  // namespace epode::trials

int main(int argc, char** argv)
{
    try {
        return epode::trials::run(epode::trials::read(argc, argv));
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "trials: %s\n", fault.what());
        return 2;
    }
}
