// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An unstable controller: the program learns once that speeds mean nothing any more, and its steps go on.
#include <ode/ext.h>

#include <cstdio>
#include <string>

#include "rig.h"

namespace epode::physics {
namespace {

std::string said;
int messages;
void note(int, const char* text, va_list arguments)
{
    char line[512];
    std::vsnprintf(line, sizeof line, text, arguments);
    said = line, ++messages;
}
void throw_note(int, const char*, va_list) { throw 7; }

struct TrustRunaway : testing::Test {
    TrustRunaway() { said.clear(), messages = 0, dSetMessageHandler(&note); }
    ~TrustRunaway() override
    {
        dSetMessageHandler(nullptr);
        dWorldDestroy(world);
    }
    // The second of three; one step makes its spin five times as fast and turns it round.
    bool control()
    {
        const dReal w = dBodyGetAngularVel(bodies[1])[1];
        if (std::fabs(w) > tol(1e60, 1e15)) return false;
        dBodySetAngularVel(bodies[1], 0, -5 * w, 0);
        return true;
    }

    dWorldID world = dWorldCreate();
    dBodyID bodies[3] = {dBodyCreate(world), dBodyCreate(world), dBodyCreate(world)};
};

TEST_F(TrustRunaway, is_reported_once_by_every_stepper_and_steps_go_on)
{
    const auto many = [](dWorldID w, dReal h) {
        return dWorldsStep(&w, 1, h, dStepperHybrid, 4, 1, 2, nullptr);
    };
    const auto fast = [](dWorldID w, dReal h) { return dWorldStepFast1(w, h, 4); };
    for (const auto step : {+[](dWorldID w, dReal h) { return dWorldStep(w, h); },
                            +[](dWorldID w, dReal h) { return dWorldQuickStep(w, h); },
                            +[](dWorldID w, dReal h) { return dWorldStepHybrid(w, h); }, +fast, +many}) {
        dWorldDestroy(world);
        world = dWorldCreate();
        for (dBodyID& body : bodies) body = dBodyCreate(world);
        dBodySetAngularVel(bodies[1], 0, 1, 0);
        said.clear(), messages = 0;
        int steps = 0, first = 0;
        while (control()) {
            ASSERT_EQ(step(world, real(0.001)), 1);
            ++steps;
            if (messages == 1 && first == 0) first = steps;
        }
        EXPECT_EQ(messages, 1);
        EXPECT_GT(steps, 15);
        EXPECT_EQ(first, 15) << "5^15 is 3e10";
        EXPECT_NE(said.find("body 1 (of 3"), std::string::npos) << said;
        EXPECT_NE(said.find("step 15"), std::string::npos) << said;
    }
}

TEST_F(TrustRunaway, is_not_reported_of_what_is_merely_fast)
{
    dWorldSetGravity(world, 0, 0, 0);
    dBodySetLinearVel(bodies[0], real(9e9), 0, 0);
    dBodySetAngularVel(bodies[2], 0, 0, real(9e9));
    dWorldStep(world, real(0.001));
    EXPECT_EQ(messages, 0) << said;
    dBodySetLinearVel(bodies[0], real(2e10), 0, 0);
    dWorldStep(world, real(0.001));
    EXPECT_EQ(messages, 1);
}

TEST_F(TrustRunaway, lets_handlers_leave)
{
    dSetMessageHandler(&throw_note);
    dBodySetLinearVel(bodies[0], real(2e10), 0, 0);
    EXPECT_THROW(dWorldStep(world, real(0.001)), int);
    dWorldID both[] = {world, dWorldCreate()};
    dBodySetLinearVel(dBodyCreate(both[1]), real(2e10), 0, 0);
    EXPECT_THROW(dWorldsStep(both, 2, real(0.001), dStepperExact, 1, 1, 2, nullptr), int);
    dSetMessageHandler(&note);
    EXPECT_EQ(dWorldStep(world, real(0.001)), 1) << "the step had been finished";
    EXPECT_EQ(dWorldStep(both[1], real(0.001)), 1);
    EXPECT_EQ(messages, 0);
    dWorldDestroy(both[1]);
}

}  // namespace
}  // namespace epode::physics
