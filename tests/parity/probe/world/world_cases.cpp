// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// World parameters: defaults, set and read back, and what a new body copies from its world.
#include "case_list.h"

namespace parity {
namespace {

void put_world(Output& out, const std::string& key, dWorldID w)
{
    dVector3 g = {0, 0, 0, 0};
    dWorldGetGravity(w, g);
    out.put(key + ".gravity", g, 3);
    out.put(key + ".erp-cfm", {dWorldGetERP(w), dWorldGetCFM(w)});
    out.put(key + ".auto-disable",
            {dWorldGetAutoDisableFlag(w) != 0 ? 1.0 : 0.0, dWorldGetAutoDisableLinearThreshold(w),
             dWorldGetAutoDisableAngularThreshold(w), static_cast<double>(dWorldGetAutoDisableSteps(w)),
             dWorldGetAutoDisableTime(w), static_cast<double>(dWorldGetAutoDisableAverageSamplesCount(w))});
    out.put(key + ".damping",
            {dWorldGetLinearDamping(w), dWorldGetAngularDamping(w), dWorldGetLinearDampingThreshold(w),
             dWorldGetAngularDampingThreshold(w), dWorldGetMaxAngularSpeed(w)});
    out.put(key + ".contact", {dWorldGetContactMaxCorrectingVel(w), dWorldGetContactSurfaceLayer(w)});
    out.put(key + ".quick",
            {static_cast<double>(dWorldGetQuickStepNumIterations(w)), dWorldGetQuickStepW(w)});
    out.put(key + ".threads", {static_cast<double>(dWorldGetStepIslandsProcessingMaxThreadCount(w))});
    out.put(key + ".data", {dWorldGetData(w) == nullptr ? 0.0 : 1.0});
}

void put_copied(Output& out, const std::string& key, dBodyID b)
{
    out.put(key + ".auto-disable",
            {static_cast<double>(dBodyGetAutoDisableFlag(b)), dBodyGetAutoDisableLinearThreshold(b),
             dBodyGetAutoDisableAngularThreshold(b), static_cast<double>(dBodyGetAutoDisableSteps(b)),
             dBodyGetAutoDisableTime(b), static_cast<double>(dBodyGetAutoDisableAverageSamplesCount(b))});
    out.put(key + ".damping",
            {dBodyGetLinearDamping(b), dBodyGetAngularDamping(b), dBodyGetLinearDampingThreshold(b),
             dBodyGetAngularDampingThreshold(b), dBodyGetMaxAngularSpeed(b)});
}

void set_all(dWorldID w, Random& random)
{
    dWorldSetGravity(w, random.range(-9, 9), random.range(-9, 9), random.range(-9, 9));
    dWorldSetERP(w, random.range(-1, 2));
    dWorldSetCFM(w, random.range(0, 1));
    dWorldSetAutoDisableFlag(w, random.below(2));
    dWorldSetAutoDisableLinearThreshold(w, random.range(-1, 1));
    dWorldSetAutoDisableAngularThreshold(w, random.range(-1, 1));
    dWorldSetAutoDisableSteps(w, random.below(50));
    dWorldSetAutoDisableTime(w, random.range(0, 2));
    dWorldSetAutoDisableAverageSamplesCount(w, static_cast<unsigned>(random.below(5)));
    dWorldSetLinearDampingThreshold(w, random.range(0, 1));
    dWorldSetAngularDampingThreshold(w, random.range(0, 1));
    dWorldSetDamping(w, random.range(0, 1), random.range(0, 1));
    dWorldSetMaxAngularSpeed(w, random.range(0, 200));
    dWorldSetContactMaxCorrectingVel(w, random.range(0, 10));
    dWorldSetContactSurfaceLayer(w, random.range(0, 0.1));
    dWorldSetQuickStepNumIterations(w, random.below(100));
    dWorldSetQuickStepW(w, random.range(0.5, 2));
}

PARITY_CASE(world_parameters)
{
    const dWorldID world = dWorldCreate();
    put_world(out, "default", world);
    const dBodyID early = dBodyCreate(world);
    put_copied(out, "default-body", early);
    for (int i = 0; i < 20; ++i) {
        out.open_block("set" + std::to_string(i));
        set_all(world, rng);
        put_world(out, "world", world);
        put_copied(out, "early", early);
        const dBodyID late = dBodyCreate(world);
        put_copied(out, "late", late);
        dBodySetAutoDisableDefaults(early);
        dBodySetDampingDefaults(early);
        put_copied(out, "refreshed", early);
        dBodyDestroy(late);
    }
    dWorldDestroy(world);
}

PARITY_CASE(world_impulse)
{
    const dWorldID world = dWorldCreate();
    for (int i = 0; i < 10; ++i) {
        const Vec3 impulse = rng.in_cube(10);
        dVector3 force = {0, 0, 0, 0};
        dWorldImpulseToForce(world, rng.range(0.001, 0.1), impulse.x, impulse.y, impulse.z, force);
        out.put("force" + std::to_string(i), force, 3);
    }
    dWorldDestroy(world);
}

// Exact binary fractions, so that the last digit says how position and velocity are advanced.
PARITY_CASE(world_free_fall)
{
    const dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    const dBodyID body = dBodyCreate(world);
    for (int i = 0; i < 100; ++i) { dWorldStep(world, 0.01); }
    out.put_body("exact", body);
    for (int i = 0; i < 100; ++i) { dWorldQuickStep(world, 0.01); }
    out.put_body("quick", body);
    dWorldDestroy(world);
}

}  // namespace
}  // namespace parity
