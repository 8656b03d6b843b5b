// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One thread, CPU time of the process. The library of robots is asked for at run time, since this program runs on Debian's libode too.
#include "bench/runs/loaded_robot.h"

#include <epode/robots.h>
#include <fmt/format.h>
#include <ode/report.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "bench/engines/stopwatch.h"
#include "bench/runs/game_worlds.h"

namespace epode::bench {
namespace {

constexpr int kHeld = 5, kRobotPreset = 2;

struct Robots {
    decltype(&dRobotModelLoad) load;
    decltype(&dRobotCreate) create;
    decltype(&dRobotModelGetNumActuators) actuators;
    decltype(&dRobotSetControl) control;

    bool find_all()
    {
        if (!dlopen("libepode_robots.so.0", RTLD_NOW | RTLD_GLOBAL)) return false;
        load = find<decltype(load)>("dRobotModelLoad"), create = find<decltype(create)>("dRobotCreate");
        actuators = find<decltype(actuators)>("dRobotModelGetNumActuators");
        control = find<decltype(control)>("dRobotSetControl");
        return load && create && actuators && control;
    }
};

struct Quality {
    int in_joints = 0;  // steps of which an island is made in joint coordinates
    double joint_error = 0, residual = 0;
};

class LoadedRobot {
  public:
    LoadedRobot(const Robots& robots, dRobotModelID model) : robots_(robots)
    {
        dWorldSetGravity(world_, 0, 0, dReal(-9.81));
        find<SetNumber>("dWorldUseDefaults")(world_, kRobotPreset);
        find<void (*)(dWorldID, dSpaceID)>("dWorldSetContactSpace")(world_, space_);
        robot_ = robots_.create(world_, space_, model, nullptr, nullptr);
        actuators_ = robots_.actuators(model);
    }
    LoadedRobot(const LoadedRobot&) = delete;
    LoadedRobot& operator=(const LoadedRobot&) = delete;
    ~LoadedRobot() { dWorldDestroy(world_), dSpaceDestroy(space_); }

    bool made() const { return robot_ != nullptr; }

    void step(double h)
    {
        static const auto hybrid = find<MakeStep>("dWorldStepHybrid");
        for (int i = 0; steps_ % kHeld == 0 && i < actuators_; ++i)
            robots_.control(robot_, i, dReal(random()));
        ++steps_;
        hybrid(world_, dReal(h));
    }

    void judge(double h, Quality& quality)
    {
        static const auto of_step = find<decltype(&dWorldGetStepReport)>("dWorldGetStepReport");
        static const auto of_island = find<decltype(&dWorldGetIslandStepReport)>("dWorldGetIslandStepReport");
        find<SetNumber>("dWorldSetStepReportMode")(world_, 1);
        step(h);
        dWorldStepReport report;
        report.struct_size = sizeof report;
        if (!of_step(world_, &report)) return;
        quality.joint_error =
            std::max({quality.joint_error, double(report.joint_error), double(report.joint_angle_error)});
        quality.residual = std::max(quality.residual, double(report.residual));
        dIslandStepReport island;
        island.struct_size = sizeof island;
        bool in_joints = false;
        for (int i = 0; i < report.islands && of_island(world_, i, &island); ++i)
            in_joints |= island.method == dIslandMethodJointCoordinates;
        quality.in_joints += in_joints;
    }

  private:
    double random()
    {
        state_ = state_ * 1664525u + 1013904223u;
        return 2 * double(state_ >> 8) / double(1 << 24) - 1;
    }

    const Robots& robots_;
    const dWorldID world_ = dWorldCreate();
    const dSpaceID space_ = dHashSpaceCreate(nullptr);
    dRobotID robot_ = nullptr;
    int actuators_ = 0, steps_ = 0;
    std::uint32_t state_ = 12345;
};

}  // namespace

int bench_loaded_robot(const LoadedRobotOptions& options)
{
    Robots robots{};
    if (!robots.find_all()) {
        fmt::print(stderr, "epode_bench: there is no libepode_robots.so.0\n");
        return 1;
    }
    const dRobotModelID model = robots.load(options.file.c_str(), nullptr);
    LoadedRobot timed(robots, model), judged(robots, model);
    if (!model || !timed.made() || !judged.made()) return 1;
    std::vector<double> times;
    Quality quality;
    for (int i = 0; i < options.steps; ++i) {
        Stopwatch watch(false);
        timed.step(options.h);
        times.push_back(1e3 * watch.lap());
        if (!options.no_quality) judged.judge(options.h, quality);
    }
    double mean = 0;
    for (double t : times) mean += t / double(times.size());
    std::sort(times.begin(), times.end());
    fmt::print(
        "| robot | us a step: mean | median | worst | in joint coordinates, % | joint error, m, rad | "
        "residual |\n");
    fmt::print(
        "|---|---|---|---|---|---|---|\n| {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1e} | {:.1e} |\n",
        options.file, mean, times[times.size() / 2], times.back(), 100.0 * quality.in_joints / options.steps,
        quality.joint_error, quality.residual);
    return 0;
}

}  // namespace epode::bench
