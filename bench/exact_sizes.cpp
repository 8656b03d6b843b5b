// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Four kinds of island: chains of ball joints (3 rows a link, all equalities), a box on the floor (12 rows: 4
// contacts with friction), stacks (12 rows a box) and walls of bricks in running bond (24 rows a brick above
// the first course), most of them inequalities. A world holds as many equal islands as make about 600 rows,
// so that small ones are timed above the clock's grain. Before each step every body is put back to its start
// with a small velocity from a generator of our own: so any library solves the same problems, and one that
// lets a stack fall is not rewarded with fewer rows. The figure is the time of dWorldStep alone, per island.
#include "bench/exact_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "scenes/build.h"
#include "scenes/extensions.h"
#include "scenes/measure.h"
#include "scenes/messages.h"

namespace epode::bench {

namespace {

using namespace scenes;

constexpr int kRowsPerWorld = 600;
constexpr int kWarmUpSteps = 5;
constexpr double kDt = 0.01;
constexpr double kOverlap = 0.001;  // so that every touching pair has all its contacts

void nothing(Scene&) {}
constexpr Recipe kEmpty = {"exact-sizes", "islands of a given size", kDt, 1, Stepper::kExact, nothing};

struct Case {
    const char* kind;
    int rows;    // of one island
    int size;    // links, boxes, or bricks in the lowest course
    int height;  // courses
    void (*add)(Scene&, const Case&, Vec at);
};

void add_chain(Scene& scene, const Case& c, Vec at)
{
    const double pitch = 0.3;
    dBodyID previous = nullptr;
    for (int i = 0; i < c.size; ++i) {
        const Vec from = at + Vec{i * pitch, 0, c.size * pitch + 1};
        dBodyID link = add_limb(scene, 0.05, 1000, from, from + pitch * kX);
        set_bits(link, 1, 0);
        add_ball(scene, link, previous, from);
        previous = link;
    }
}

void add_stack(Scene& scene, const Case& c, Vec at)
{
    const double pitch = 0.5 - kOverlap;
    for (int i = 0; i < c.size; ++i)
        add_box(scene, {1, 1, 0.5}, 1000, at + Vec{0, 0, 0.25 - kOverlap + pitch * i});
}

void add_wall(Scene& scene, const Case& c, Vec at)
{
    const double pitch = 0.5 - kOverlap;
    for (int course = 0; course < c.height; ++course) {
        for (int i = 0; i < c.size - course; ++i) {
            add_box(scene, {1, 0.5, 0.5}, 1000,
                    at + Vec{1.05 * (i + 0.5 * course), 0, 0.25 - kOverlap + pitch * course});
        }
    }
}

constexpr Case kCases[] = {
    {"chain", 12, 4, 0, add_chain},    {"chain", 24, 8, 0, add_chain},   {"chain", 60, 20, 0, add_chain},
    {"chain", 96, 32, 0, add_chain},   {"chain", 150, 50, 0, add_chain}, {"chain", 201, 67, 0, add_chain},
    {"chain", 300, 100, 0, add_chain}, {"box", 12, 1, 0, add_stack},     {"stack", 24, 2, 0, add_stack},
    {"stack", 60, 5, 0, add_stack},    {"stack", 96, 8, 0, add_stack},   {"stack", 156, 13, 0, add_stack},
    {"stack", 204, 17, 0, add_stack},  {"stack", 300, 25, 0, add_stack}, {"wall", 48, 2, 2, add_wall},
    {"wall", 84, 3, 2, add_wall},      {"wall", 108, 3, 3, add_wall},    {"wall", 168, 4, 3, add_wall},
    {"wall", 192, 4, 4, add_wall},     {"wall", 288, 6, 3, add_wall},
};

struct Result {
    double us = 0;    // of dWorldStep, per island
    double rows = 0;  // found, mean per island: a library may see more or fewer contacts
    int not_finite = 0;
};

// The start of every body, and the way back to it.
class Start {
  public:
    explicit Start(const Scene& scene)
    {
        for (dBodyID body : scene.bodies()) {
            const dReal* p = dBodyGetPosition(body);
            const dReal* q = dBodyGetQuaternion(body);
            poses_.push_back({body, {p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}});
        }
    }

    void restore(Lcg& random) const
    {
        const auto push = [&random] { return random.uniform(-0.05, 0.05); };
        for (const Pose& pose : poses_) {
            const dQuaternion q = {dReal(pose.turn.w), dReal(pose.turn.x), dReal(pose.turn.y),
                                   dReal(pose.turn.z)};
            dBodySetPosition(pose.body, dReal(pose.at.x), dReal(pose.at.y), dReal(pose.at.z));
            dBodySetQuaternion(pose.body, q);
            const Vec linear{push(), push(), push()};
            const Vec angular{push(), push(), push()};
            set_velocity(pose.body, linear, angular);
        }
    }

  private:
    struct Pose {
        dBodyID body;
        Vec at;
        Turn turn;
    };
    std::vector<Pose> poses_;
};

Result time_once(const Case& c, int steps)
{
    Scene scene(kEmpty);
    add_ground(scene);
    const int islands = std::max(1, kRowsPerWorld / c.rows);
    for (int i = 0; i < islands; ++i) c.add(scene, c, {0, 2.0 * i, 0});

    const Start start(scene);
    Lcg random(1);
    std::vector<double> times;
    double rows = 0;
    for (int i = 0; i < kWarmUpSteps + steps; ++i) {
        start.restore(random);
        scene.step(Stepper::kExact, kDt);
        if (i < kWarmUpSteps) continue;
        times.push_back(scene.times().step_ms);
        rows += 3.0 * double(scene.contacts().size() + scene.joints().size());
    }
    return {quantile(times, 0.5) * 1e3 / islands, rows / steps / islands, bodies_not_finite(scene)};
}

Result time_best(const Case& c, const SizesOptions& options)
{
    Result best = time_once(c, options.steps);
    for (int i = 1; i < options.repeat; ++i) best.us = std::min(best.us, time_once(c, options.steps).us);
    return best;
}

}  // namespace

int bench_exact_sizes(const SizesOptions& options)
{
    int not_finite = 0;
    const MessageCounter messages;
    if (options.json) {
        fmt::print("{{\n  \"library\": \"{}\",\n  \"cases\": [", loaded_library());
    } else {
        fmt::print("library            {}\n# kind rows rows_found us_per_step\n", loaded_library());
    }
    const char* separator = "\n";
    for (const Case& c : kCases) {
        const Result result = time_best(c, options);
        not_finite += result.not_finite;
        if (options.json) {
            fmt::print(
                "{}    {{\"kind\": \"{}\", \"rows\": {}, \"rows_found\": {:.1f}, \"us_per_step\": {:.4g}}}",
                separator, c.kind, c.rows, result.rows, result.us);
        } else {
            fmt::print("{:<6} {:>4} {:>7.1f} {:>10.2f}\n", c.kind, c.rows, result.rows, result.us);
        }
        separator = ",\n";
    }
    if (options.json) {
        fmt::print("\n  ],\n  \"messages\": {}\n}}\n", messages.count());
    } else {
        fmt::print("# messages {}\n", messages.count());
    }
    return not_finite > 0 ? 1 : 0;
}

}  // namespace epode::bench
