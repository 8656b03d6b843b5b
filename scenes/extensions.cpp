// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Names and layouts of ode/ext.h, repeated here by hand because the headers of ODE itself do not have them.
// struct_size guards the layout: the library fills no more than it is told there is room for.
#include "scenes/extensions.h"

#include <dlfcn.h>

#include <fstream>

namespace epode::scenes {

namespace {

struct RawStepReport {
    unsigned struct_size;
    int islands, bodies, joints, rows;
    double residual;
    int iterations, fallbacks, contained_islands;
};

template <class Function>
Function find(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

using StepFast = int (*)(dWorldID, dReal, int);
using SetMode = void (*)(dWorldID, int);
using SetWarmStarting = void (*)(dWorldID, dReal);
using GetReport = int (*)(dWorldID, RawStepReport*);

StepFast fast_function()
{
    static const StepFast function = find<StepFast>("dWorldStepFast1");
    return function;
}

}  // namespace

bool has_step_fast() { return fast_function() != nullptr; }

int step_fast(dWorldID world, dReal dt, int small_steps)
{
    return has_step_fast() ? fast_function()(world, dt, small_steps) : 0;
}

bool has_step_threads() { return find<SetMode>("dWorldSetStepThreads") != nullptr; }

bool set_step_threads(dWorldID world, int threads)
{
    static const SetMode function = find<SetMode>("dWorldSetStepThreads");
    if (!function) return false;
    function(world, threads);
    return true;
}

bool request_step_report(dWorldID world, bool on)
{
    static const SetMode function = find<SetMode>("dWorldSetStepReportMode");
    if (!function) return false;
    function(world, on ? 1 : 0);
    return true;
}

std::optional<StepReport> step_report(dWorldID world)
{
    static const GetReport function = find<GetReport>("dWorldGetStepReport");
    if (!function) return std::nullopt;
    RawStepReport raw{};
    raw.struct_size = sizeof raw;
    if (!function(world, &raw)) return std::nullopt;
    StepReport report;
    report.residual = raw.residual;
    report.islands = raw.islands;
    report.bodies = raw.bodies;
    report.joints = raw.joints;
    report.rows = raw.rows;
    report.iterations = raw.iterations;
    report.fallbacks = raw.fallbacks;
    report.contained_islands = raw.contained_islands;
    return report;
}

bool set_warm_starting(dWorldID world, double factor)
{
    static const SetWarmStarting function = find<SetWarmStarting>("dWorldSetQuickStepWarmStarting");
    if (!function) return false;
    function(world, dReal(factor));
    return true;
}

bool set_step_projection(dWorldID world, int iterations)
{
    static const SetMode function = find<SetMode>("dWorldSetStepProjection");
    if (!function) return false;
    function(world, iterations);
    return true;
}

std::string loaded_library()
{
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const size_t path = line.find('/');
        if (path != std::string::npos && line.find("/libode", path) != std::string::npos)
            return line.substr(path);
    }
    return "statically linked";
}

}  // namespace epode::scenes
