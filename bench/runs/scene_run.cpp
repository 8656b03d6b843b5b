// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Quality is judged after each eighth of the run, outside the timed steps; the worst of penetration and joint
// error counts, drift, energy, speed and losses are those of the end. `hash` is FNV-1a over the last state's
// numbers: two runs with equal hashes have computed the same.
#include "bench/runs/scene_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "bench/engines/stopwatch.h"
#include "bench/runs/memory_meter.h"
#include "bench/scenes/export.h"

namespace epode::bench {

namespace {

constexpr int kSamples = 8;

int refuse(int code, const std::string& problem)
{
    fmt::print(stderr, "epode_bench: {}\n", problem);
    return code;
}

int no_scene(const std::string& name)
{
    std::string names;
    for (const NamedSetting& known : all_settings()) names += fmt::format(" {}", known.setting->name);
    return refuse(2, fmt::format("there is no benchmark scene '{}'. Scenes:{}", name, names));
}

const EngineEntry* find_engine(const std::string& name)
{
    for (const EngineEntry* entry : engine_entries()) {
        if (name == entry->name) return entry;
    }
    return nullptr;
}

bool sampled(int step, int steps) { return step * kSamples / steps != (step - 1) * kSamples / steps; }

// The worst and the last of what samples showed.
class Verdict {
  public:
    void add(const Quality& now)
    {
        const Quality before = quality;
        quality = now;
        quality.penetration_max = std::max(now.penetration_max, before.penetration_max);
        quality.joint_error_max = std::max(now.joint_error_max, before.joint_error_max);
        quality.not_finite = std::max(now.not_finite, before.not_finite);
        penetration_sum_ += now.penetration_mean;
        ++samples_;
        quality.penetration_mean = penetration_sum_ / samples_;
    }

    std::string json() const
    {
        const Quality& q = quality;
        return fmt::format(
            "\"penetration_max\":{:.6g},\"penetration_mean\":{:.6g},\"penetration_end_pairs\":{},"
            "\"joint_error_max\":{:.6g},\"joint_error_end_mean\":{:.6g},\"drift_max\":{:.6g},"
            "\"drift_mean\":{:.6g},\"energy\":{:.6g},\"speed\":{:.6g},\"lost\":{},\"not_finite\":{}",
            q.penetration_max, q.penetration_mean, q.overlaps, q.joint_error_max, q.joint_error_mean,
            q.drift_max, q.drift_mean, q.energy, q.speed, q.lost, q.not_finite);
    }

    Quality quality;

  private:
    double penetration_sum_ = 0;
    int samples_ = 0;
};

std::uint64_t fingerprint(const State& state)
{
    std::uint64_t hash = 14695981039346656037u;
    for (const BodyState& s : state) {
        unsigned char bytes[sizeof s];
        std::memcpy(bytes, &s, sizeof s);
        for (unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211u;
    }
    return hash;
}

struct RunTimes {
    std::vector<double> total;  // ms, step by step
    StageTimes sum;

    void add(const StageTimes& t)
    {
        total.push_back(t.total());
        sum.collide += t.collide;
        sum.solve += t.solve;
        sum.rest += t.rest;
    }

    std::string json() const
    {
        const double n = double(std::max<size_t>(1, total.size()));
        std::vector<double> sorted = total;
        std::sort(sorted.begin(), sorted.end());
        std::string all = fmt::format(
            "\"ms\":{:.6g},\"ms_median\":{:.6g},\"ms_collide\":{:.6g},\"ms_solve\":{:.6g},\"ms_rest\":{:.6g},"
            "\"ms_steps\":[",
            sum.total() / n, sorted.empty() ? 0 : sorted[sorted.size() / 2], sum.collide / n, sum.solve / n,
            sum.rest / n);
        for (size_t i = 0; i < total.size(); ++i) all += fmt::format("{}{:.4g}", i > 0 ? "," : "", total[i]);
        return all + "]";
    }
};

std::string simulate(Engine& engine, const SceneData& scene, bool judged, RunTimes& times, int& not_finite)
{
    Verdict verdict;
    State state;
    double contacts = 0;
    for (int i = 1; i <= scene.steps; ++i) {
        times.add(engine.step((i - 1) * scene.dt));
        contacts += engine.contacts();
        if (!judged || !sampled(i, scene.steps)) continue;
        engine.read(state);
        verdict.add(judge(scene, state));
    }
    engine.read(state);
    not_finite = verdict.quality.not_finite;
    return fmt::format("\"contacts\":{:.6g},{}\"hash\":\"{:016x}\"", contacts / scene.steps,
                       judged ? verdict.json() + "," : "", fingerprint(state));
}

// Each step casts all rays again.
std::string shoot(Engine& engine, const SceneData& scene, bool wall, RunTimes& times)
{
    RayAnswer answer = engine.cast({scene.rays.front()});  // what is built at the first query
    for (int i = 0; i < scene.steps; ++i) {
        Stopwatch watch(wall);
        answer = engine.cast(scene.rays);
        times.add({watch.lap(), 0, 0});
    }
    return fmt::format("\"rays\":{},\"hits\":{},\"distance\":{:.6f}", scene.rays.size(), answer.hits,
                       answer.distance);
}

std::string fly(Engine& engine, const SceneData& scene, bool wall, RunTimes& times)
{
    std::vector<Vec> places(scene.bodies.size());
    double pairs = 0;
    for (int i = 0; i <= scene.steps; ++i) {
        for (size_t k = 0; k < places.size(); ++k) places[k] = flown(scene, scene.bodies[k], i * scene.dt);
        Stopwatch watch(wall);
        const int now = engine.pairs_at(places);
        if (i == 0) continue;  // everything is new to it
        times.add({watch.lap(), 0, 0});
        pairs += now;
    }
    return fmt::format("\"pairs\":{:.6g}", pairs / scene.steps);
}

// Through strtod, which knows what an engine that has failed writes.
std::optional<State> read_state(std::istream& in, size_t bodies)
{
    State state(bodies);
    for (BodyState& s : state) {
        for (double* number :
             {&s.pos.x, &s.pos.y, &s.pos.z, &s.turn.w, &s.turn.x, &s.turn.y, &s.turn.z, &s.linear.x,
              &s.linear.y, &s.linear.z, &s.angular.x, &s.angular.y, &s.angular.z}) {
            std::string word;
            char* end = nullptr;
            if (!(in >> word)) return std::nullopt;
            *number = std::strtod(word.c_str(), &end);
            if (*end != '\0') return std::nullopt;
        }
    }
    return state;
}

}  // namespace

int run_scene(const SceneRunOptions& options)
{
    const std::optional<SceneData> scene = make_scene(options.scene);
    if (!scene) return no_scene(options.scene.name);
    const EngineEntry* entry = find_engine(options.engine_name);
    if (!entry) return refuse(2, fmt::format("there is no engine '{}' in this build", options.engine_name));
    std::string refusal;
    if (options.memory) meter_memory();
    const std::unique_ptr<Engine> engine = entry->make(*scene, options.engine, refusal);
    if (!engine) return refuse(3, refusal);
    const size_t scene_bytes = bytes_now();

    RunTimes times;
    int not_finite = 0;
    std::string answer;
    const bool wall = options.engine.threads > 1;
    if (scene->task == Task::kRays) answer = shoot(*engine, *scene, wall, times);
    if (scene->task == Task::kBroadPhase) answer = fly(*engine, *scene, wall, times);
    if (scene->task == Task::kSimulate) answer = simulate(*engine, *scene, options.judged, times, not_finite);
    if (options.memory)
        answer += fmt::format(",\"bytes_scene\":{},\"bytes_steps\":{},\"contacts_end\":{}", scene_bytes,
                              peak_bytes() - scene_bytes, engine->contacts());
    fmt::print(
        "{{\"scene\":\"{}\",\"size\":{},\"engine\":\"{}\",\"version\":\"{}\",\"threads\":{},\"clock\":\"{}\","
        "\"steps\":{},\"bodies\":{},\"joints\":{},{},{}}}\n",
        scene->name, scene->size, entry->name, engine->version(), options.engine.threads,
        wall ? "wall" : "process", scene->steps, scene->bodies.size(), scene->joints.size(), answer,
        times.json());
    return not_finite > 0 ? 1 : 0;
}

int list_scenes()
{
    for (const auto& [recipe, s] : all_settings()) {
        fmt::print(
            "{{\"name\":\"{}\",\"about\":\"{}\",\"size\":{},\"steps\":{},\"quick_size\":{},\"quick_steps\":{}"
            ","
            "\"goal\":{}}}\n",
            s->name, recipe->about, s->size, s->steps, s->quick_size, s->quick_steps, s->goal);
    }
    return 0;
}

int export_scene(const SceneChoice& choice)
{
    const std::optional<SceneData> scene = make_scene(choice);
    if (!scene) return no_scene(choice.name);
    fmt::print("{}", to_json(*scene));
    return 0;
}

int judge_file(const SceneChoice& choice, const std::string& path)
{
    const std::optional<SceneData> scene = make_scene(choice);
    if (!scene) return no_scene(choice.name);
    std::ifstream file(path);
    if (!file) return refuse(2, fmt::format("cannot read {}", path));
    Verdict verdict;
    std::string word;
    int step = 0;
    while (file >> word >> step) {
        const std::optional<State> state = read_state(file, scene->bodies.size());
        if (word != "state" || !state) return refuse(2, fmt::format("{} is no file of states", path));
        verdict.add(judge(*scene, *state));
    }
    fmt::print("{{{}}}\n", verdict.json());
    return verdict.quality.not_finite > 0 ? 1 : 0;
}

}  // namespace epode::bench
