// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds: creation, parameters, the three steppers. Parameters take any finite value that ODE takes; NaN is
// refused, infinity only where it means "no limit".
#include <algorithm>
#include <cmath>

#include "api/behaviour.h"
#include "base/messages.h"
#include "base/objects/pool.h"
#include "base/objects/struct_size.h"
#include "dynamics/world.h"
#include "ode/ext.h"
#include "ode/ode.h"
#include "step/common/link.h"
#include "step/step.h"
#include "step/steppers/stepper.h"
#include "tasks/threading.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dWorldStepReport> = offsetof(dWorldStepReport, bodies);
template <>
inline constexpr std::size_t kSmallestSize<dIslandStepReport> = offsetof(dIslandStepReport, body);

}  // namespace epode

using namespace epode;

namespace {

// Beyond these a step would not come back for hours: a number that slipped, not one that somebody wants.
constexpr int kMaxIterations = 100000;

// Thresholds are kept squared.
Real square(Real x) { return x * x; }

}  // namespace

extern "C" {

dWorldID dWorldCreate()
{
    World* const world = Pool<World>::create();
    EPODE_USER_SAY(world, kOutOfMemory, nullptr);
    world->behaviour = behaviour_of_new_worlds();
    return to_handle(world);
}

void dWorldDestroy(dWorldID w)
{
    EPODE_WORLD_OR();
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world));
    mark_busy(*world, Busy::kEnd);  // the program's memory functions may be called
    int grouped = 0;
    for (const Joint& joint : world->joints) grouped += joint.grouped;
    for (Body& b : world->bodies) release_geoms(b);
    Pool<World>::destroy(world);
    // Last: a handler may do anything, and need not return.
    for (int i = 0; i < grouped; ++i) note(0, "warning: destroying world containing grouped joints");
}

void dWorldSetData(dWorldID w, void* data)
{
    EPODE_WORLD_OR();
    world->data = data;
}

void* dWorldGetData(dWorldID w)
{
    EPODE_WORLD_OR(nullptr);
    return world->data;
}

void dWorldSetGravity(dWorldID w, dReal x, dReal y, dReal z)
{
    EPODE_WORLD_OR();
    EPODE_USER(usable(x) && usable(y) && usable(z));
    const Vec3 g{x, y, z};
    if (g == world->gravity) return;
    world->gravity = g;
    if (world->wakes_sleepers())
        for (Body& body : world->bodies) wake_sleeper(body);
}

void dWorldGetGravity(dWorldID w, dVector3 gravity)
{
    EPODE_WORLD_OR();
    EPODE_USER(gravity);
    store(gravity, world->gravity);
}

// A plain number of the world: setter with its condition, getter.
#define WORLD_NUMBER(Type, Name, member, condition) \
    void dWorldSet##Name(dWorldID w, Type value)    \
    {                                               \
        EPODE_WORLD_OR();                           \
        EPODE_USER(condition);                      \
        world->member = value;                      \
    }                                               \
    Type dWorldGet##Name(dWorldID w)                \
    {                                               \
        EPODE_WORLD_OR(0);                          \
        return world->member;                       \
    }

WORLD_NUMBER(dReal, ERP, erp, usable(value))
WORLD_NUMBER(dReal, CFM, cfm, usable(value) && value >= 0)
WORLD_NUMBER(unsigned, StepIslandsProcessingMaxThreadCount, islands_max_threads, true)
void dWorldSetStepThreadingImplementation(dWorldID w, const dThreadingFunctionsInfo* functions,
                                          dThreadingImplementationID impl)
{
    EPODE_WORLD_OR();
    EPODE_USER(!functions == !impl);
    EPODE_USER_SAY(!functions || complete(*functions), "Bad threading functions info");
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world));
    world->threading = impl;
    world->threading_functions = functions ? *functions : dThreadingFunctionsInfo{};
}

WORLD_NUMBER(int, StepThreads, step_threads, value >= 0 && value <= 64)
WORLD_NUMBER(int, QuickStepNumIterations, quick_iterations, value <= kMaxIterations)
WORLD_NUMBER(dReal, QuickStepW, quick_w, usable(value))
WORLD_NUMBER(dReal, ContactMaxCorrectingVel, contact_max_vel, usable_or_infinite(value))
WORLD_NUMBER(dReal, ContactSurfaceLayer, contact_layer, usable(value))
WORLD_NUMBER(int, AutoDisableSteps, sleep.steps, true)
WORLD_NUMBER(dReal, AutoDisableTime, sleep.time, usable_or_infinite(value))
WORLD_NUMBER(dReal, LinearDamping, damping.linear_scale, usable(value))
WORLD_NUMBER(dReal, AngularDamping, damping.angular_scale, usable(value))
WORLD_NUMBER(dReal, MaxAngularSpeed, max_angular_speed, value >= 0)
WORLD_NUMBER(dReal, StepWarmStarting, warm_starting, value >= 0 && value <= 1)
WORLD_NUMBER(int, AutoEnableDepthSF1, auto_enable_depth, true)

// A threshold, kept squared.
#define WORLD_THRESHOLD(Name, member)             \
    void dWorldSet##Name(dWorldID w, dReal value) \
    {                                             \
        EPODE_WORLD_OR();                         \
        EPODE_USER(usable_or_infinite(value));    \
        world->member = square(value);            \
    }                                             \
    dReal dWorldGet##Name(dWorldID w)             \
    {                                             \
        EPODE_WORLD_OR(0);                        \
        return std::sqrt(world->member);          \
    }

WORLD_THRESHOLD(AutoDisableLinearThreshold, sleep.linear_threshold2)
WORLD_THRESHOLD(AutoDisableAngularThreshold, sleep.angular_threshold2)
WORLD_THRESHOLD(LinearDampingThreshold, damping.linear_threshold2)
WORLD_THRESHOLD(AngularDampingThreshold, damping.angular_threshold2)

void dWorldSetAutoDisableAverageSamplesCount(dWorldID w, unsigned int count)
{
    EPODE_WORLD_OR();
    EPODE_USER(count <= 1u << 20);
    world->sleep.samples = int(count);
}

int dWorldGetAutoDisableAverageSamplesCount(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->sleep.samples;
}

void dWorldSetAutoDisableFlag(dWorldID w, int on)
{
    EPODE_WORLD_OR();
    world->auto_disable = on != 0;
}

int dWorldGetAutoDisableFlag(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->auto_disable;
}

void dWorldSetDamping(dWorldID w, dReal linear, dReal angular)
{
    EPODE_WORLD_OR();
    EPODE_USER(usable(linear) && usable(angular));
    world->damping.linear_scale = linear;
    world->damping.angular_scale = angular;
}

void dWorldImpulseToForce(dWorldID w, dReal stepsize, dReal ix, dReal iy, dReal iz, dVector3 force)
{
    EPODE_WORLD_OR();
    EPODE_USER(force && usable(stepsize) && stepsize != 0 && usable(ix) && usable(iy) && usable(iz));
    store(force, Vec3{ix, iy, iz} * (1 / stepsize));
}

// ---- stepping ----

int dWorldStep(dWorldID w, dReal stepsize)
{
    EPODE_WORLD_OR(0);
    EPODE_USER(usable(stepsize) && stepsize > 0, 0);
    EPODE_MAY_STEP(*world);
    EPODE_USER_SAY(step_world(*world, kExact, stepsize, 0), kOutOfMemory, 0);
    report_unusual(*world);
    return 1;
}

int dWorldQuickStep(dWorldID w, dReal stepsize)
{
    EPODE_WORLD_OR(0);
    EPODE_USER(usable(stepsize) && stepsize > 0, 0);
    EPODE_MAY_STEP(*world);
    EPODE_USER_SAY(step_world(*world, kQuick, stepsize, world->quick_iterations), kOutOfMemory, 0);
    report_unusual(*world);
    return 1;
}

int dWorldStepFast1(dWorldID w, dReal stepsize, int maxiterations)
{
    EPODE_WORLD_OR(0);
    EPODE_USER(usable(stepsize) && stepsize > 0 && maxiterations >= 1 && maxiterations <= kMaxSubsteps, 0);
    EPODE_MAY_STEP(*world);
    EPODE_USER_SAY(step_world(*world, kSubsteps, stepsize, maxiterations), kOutOfMemory, 0);
    report_unusual(*world);
    return 1;
}

// ---- accuracy (ode/ext.h) ----

void dWorldSetExactRotation(dWorldID w, int mode)
{
    EPODE_WORLD_OR();
    EPODE_USER(mode == 0 || mode == 1);
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world));
    world->exact_rotation = mode != 0;
    for (Body& b : world->bodies) b.spin_excess = {};
}

int dWorldGetExactRotation(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->exact_rotation;
}

void dWorldSetJointCoordinates(dWorldID w, int mode)
{
    EPODE_WORLD_OR();
    EPODE_USER(mode == 0 || mode == 1);
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world));
    world->joint_coordinates = mode != 0;
}

int dWorldGetJointCoordinates(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->joint_coordinates;
}

void dWorldSetFrictionCone(dWorldID w, int mode)
{
    EPODE_WORLD_OR();
    EPODE_USER(mode == 0 || mode == 1);
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world));
    world->friction_cone = mode != 0;
}

int dWorldGetFrictionCone(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->friction_cone;
}

void dWorldSetManifoldFriction(dWorldID w, int mode)
{
    EPODE_WORLD_OR();
    EPODE_USER(mode == 0 || mode == 1);
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world));
    world->manifold_friction = mode != 0;
}

int dWorldGetManifoldFriction(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->manifold_friction;
}

WORLD_NUMBER(int, ExactSubsteps, exact_substeps, value >= 1 && value <= 1000)
WORLD_NUMBER(int, StepProjection, projection_iterations, value >= 0 && value <= 100)
WORLD_NUMBER(dReal, StepProjectionTolerance, projection_tolerance, value > 0 && value < 1)
WORLD_NUMBER(int, HybridStepper, hybrid_stepper, is_stepper(value))
WORLD_NUMBER(dReal, HybridBudget, hybrid_budget, value >= 0)
WORLD_NUMBER(int, HybridSubsteps, hybrid_substeps, value >= 1 && value <= kMaxSubsteps)

// ---- report (ode/ext.h) ----

void dWorldSetStepReportMode(dWorldID w, int mode)
{
    EPODE_WORLD_OR();
    EPODE_USER(mode == 0 || mode == 1);
    if (mode && !world->report_wanted) world->report_made = false;
    world->report_wanted = mode != 0;
}

int dWorldGetStepReportMode(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->report_wanted;
}

int dWorldGetStepReport(dWorldID w, dWorldStepReport* report)
{
    EPODE_WORLD_OR(0);
    EPODE_SIZED(report, 0);
    if (!world->report_wanted || !world->report_made) return 0;
    copy_sized(world->report, report, report->struct_size);
    return 1;
}

int dWorldGetIslandStepReport(dWorldID w, int island, dIslandStepReport* report)
{
    EPODE_WORLD_OR(0);
    EPODE_SIZED(report, 0);
    if (!world->report_wanted || !world->report_made) return 0;
    const auto islands = island_reports(*world);
    EPODE_USER(island >= 0 && std::size_t(island) < islands.size(), 0);
    copy_sized(islands[std::size_t(island)], report, report->struct_size);
    return 1;
}

}  // extern "C"
