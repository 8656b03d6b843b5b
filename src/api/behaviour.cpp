// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Behaviour versions of worlds (ode/defaults.h). A number is kept for good: what it means is decided where the
// difference is (World::acts_as_ode), and golden hashes freeze it (tests/physics/bits/behaviour_test.cpp).
#include "api/behaviour.h"

#include <cstring>

#include "base/check.h"
#include "base/environment.h"
#include "base/messages.h"
#include "ode/ext.h"
#include "step/step.h"

namespace epode {
namespace {

struct Version {
    const char* name;
    int number;
};

constexpr Version kVersions[] = {{"0.16", dBehaviour016}, {"1", dBehaviour1}};

bool is_version(int number)
{
    for (const Version& version : kVersions)
        if (version.number == number) return true;
    return false;
}

int version_in_environment()
{
    const char* const wanted = environment_value("EPODE_BEHAVIOUR");
    if (!wanted) return dBehaviour1;
    for (const Version& version : kVersions)
        if (std::strcmp(wanted, version.name) == 0) return version.number;
    note(0, "EPODE_BEHAVIOUR=%s: no such behaviour; 0.16 or 1 would be accepted, worlds have 1", wanted);
    return dBehaviour1;
}

}  // namespace

int behaviour_of_new_worlds()
{
    static const int version = version_in_environment();
    return version;
}

}  // namespace epode

using namespace epode;

extern "C" {

void dWorldSetBehaviour(dWorldID w, int version)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world);
    EPODE_USER_SAY(is_version(version), "a version that is no dBehaviour");
    EPODE_USER_SAY(!in_step(*world), busy_text(*world));
    world->behaviour = version;
}

int dWorldGetBehaviour(dWorldID w)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world, 0);
    return world->behaviour;
}

}  // extern "C"
