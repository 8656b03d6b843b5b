// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Roll-backs that are refused, across what cannot come back, in worlds where objects were created and destroyed since: nothing
// changes, and the world goes on with the bits of a twin that was never asked.
#include <functional>

#include "scene.h"

namespace epode::states {
namespace {

constexpr dReal kH = dReal(1) / 60;

// A pile on a floor, with a fluid and a vehicle.
struct Yard {
    Yard()
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81)), dWorldSetContactSpace(world, space);
        dCreatePlane(space, 0, 0, 1, 0);
        for (int i = 0; i < 4; ++i) balls[i] = ball(dReal(0.1) * dReal(i), dReal(0.5) + dReal(i));
        car = ball(-20, 5);
        dVehicleCreate(car, nullptr);
        dFluidSetPlane(fluid, 0, 0, 1, -1);
        sleeper = ball(20, dReal(0.5)), wanderer = dCreateBox(space, 1, 1, 1);
        dGeomSetPosition(wanderer, 0, 9, 0);
        dWorldSetHistory(world, 20);
        step(10);
        // What has happened since: newcomers in contact, one destroyed, a geom that has left for another space, a body with another
        // mass that is kinematic now, one that sleeps under a force.
        newcomer = ball(dReal(0.3), 2);
        dGeomSetPosition(dCreateBox(space, 1, 1, 1), dReal(-0.8), 0, dReal(0.5));
        step(5);
        dBodyDestroy(balls[3]);
        step(3);
        dSpaceRemove(space, wanderer), dSpaceAdd(elsewhere, wanderer);
        dMass mass;
        dMassSetSphereTotal(&mass, 3, dReal(0.5));
        dBodySetMass(newcomer, &mass), dBodySetMass(balls[2], &mass), dBodySetKinematic(balls[2]);
        dBodyDisable(sleeper), dBodyAddForce(sleeper, 1, 2, 3);
    }
    ~Yard() { dWorldDestroy(world), dSpaceDestroy(space), dSpaceDestroy(elsewhere); }
    Yard(const Yard&) = delete;
    Yard& operator=(const Yard&) = delete;

    void step(int n) const
    {
        for (int i = 0; i < n; ++i) EXPECT_EQ(dWorldStepFast1(world, kH, 4), 1);
    }
    dBodyID ball(dReal x, dReal z) const
    {
        const dBodyID body = dBodyCreate(world);
        dGeomSetBody(dCreateSphere(space, dReal(0.5)), body);
        dBodySetPosition(body, x, 0, z);
        return body;
    }

    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr), elsewhere = dSimpleSpaceCreate(nullptr);
    dFluidID fluid = dFluidCreate(world);
    dBodyID balls[4], car, newcomer, sleeper;
    dGeomID wanderer;
};

// What the program does that no roll-back takes back.
struct Deed {
    const char* name;
    const char* message;
    std::function<void(Yard&)> act;
};

const Deed kDeeds[] = {
    {"vehicle_made", "vehicle", [](Yard& yard) { dVehicleCreate(yard.balls[0], nullptr); }},
    {"wheel_added", "vehicle",
     [](Yard& yard) {
         dVehicleWheel wheel;
         dVehicleWheelInit(&wheel, sizeof wheel);
         wheel.position[2] = dReal(-0.3);
         EXPECT_EQ(dVehicleAddWheel(yard.car, &wheel), 1) << Messages::last();
     }},
    {"fluid_made", "fluids", [](Yard& yard) { dFluidCreate(yard.world); }},
    {"fluid_destroyed", "fluids", [](Yard& yard) { dFluidDestroy(yard.fluid); }},
    {"contact_space_changed", "geoms",
     [](Yard& yard) {
         const dSpaceID other = dHashSpaceCreate(yard.space);
         dWorldSetContactSpace(yard.world, other);
     }},
};

class RefusedRollBack : public testing::TestWithParam<Deed> {};
INSTANTIATE_TEST_SUITE_P(deeds, RefusedRollBack, testing::ValuesIn(kDeeds),
                         [](const auto& at) { return std::string(at.param.name); });

TEST_P(RefusedRollBack, changes_nothing)
{
    const Messages messages;
    Yard yard, twin;
    GetParam().act(yard), GetParam().act(twin);
    ASSERT_EQ(difference(state_of(yard.world), state_of(twin.world)), "");
    for (const int frames : {3, 8, 12}) {
        const Bytes before = state_of(yard.world);
        EXPECT_EQ(dWorldRollBack(yard.world, frames), 0) << frames;
        EXPECT_NE(Messages::last().find(GetParam().message), std::string::npos) << Messages::last();
        EXPECT_EQ(difference(state_of(yard.world), before), "") << frames;
        EXPECT_EQ(dGeomGetSpace(yard.wanderer), yard.elsewhere);
        EXPECT_EQ(dWorldGetHistoryFrames(yard.world), dWorldGetHistoryFrames(twin.world));
    }
    yard.step(20), twin.step(20);
    EXPECT_EQ(difference(state_of(yard.world), state_of(twin.world)), "");
}

}  // namespace
}  // namespace epode::states
