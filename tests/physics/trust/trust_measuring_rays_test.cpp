// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ray measures: it carries, stops and pushes nothing, also as what a geom transform holds.
#include <ode/ext.h>

#include "rig.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // transforms are part of the interface

namespace epode::physics {
namespace {

// From that height up, or along x.
dGeomID ray_in_transform(dSpaceID space, double z, double length, bool level = false)
{
    const dGeomID ray = dCreateRay(nullptr, real(length)), holder = dCreateGeomTransform(space);
    dGeomRaySet(ray, level ? real(-length / 2) : 0, 0, real(z), level, 0, !level);
    dGeomTransformSetGeom(holder, ray);
    dGeomTransformSetCleanup(holder, 1);
    return holder;
}

TEST(MeasuringRays, let_characters_pass)
{
    Sim sim;
    dCreatePlane(sim.space, 0, 0, 1, 0);
    const dGeomID character = dCharacterCreate(sim.space, nullptr);
    dCharacterSetPosition(character, -1, 0, 0);
    ray_in_transform(sim.space, 0.1, 5);
    const dVector3 velocity = {2, 0, 0};
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(dCharacterWalk(character, velocity, 0, real(0.01)), dCharacterOnGround);
    dVector3 feet;
    ASSERT_EQ(dCharacterGetPosition(character, feet), 1);
    EXPECT_NEAR(feet[0], 1, 1e-5);
    EXPECT_NEAR(feet[1], 0, 1e-5);
}

TEST(MeasuringRays, carry_no_wheels)
{
    Sim sim;
    const dBodyID body = sim.box({0, 0, 0.5}, {1, 1, 0.2}, 100);
    ASSERT_EQ(dVehicleCreate(body, nullptr), 1);
    dVehicleWheel wheel;
    dVehicleWheelInit(&wheel, sizeof wheel);
    for (const int cast : {dWheelRay, dWheelSphere, dWheelCylinder}) {
        wheel.cast = cast, wheel.axle = cast;
        ASSERT_GE(dVehicleAddWheel(body, &wheel), 0);
    }
    ray_in_transform(sim.space, 0.25, 4, true);
    EXPECT_EQ(dVehicleUpdate(body, real(0.01)), 0);
    for (int i = 0; i < 3; ++i) {
        dVehicleWheelReport report = {};
        report.struct_size = sizeof report;
        ASSERT_EQ(dVehicleGetWheelReport(body, i, &report), 1);
        EXPECT_EQ(report.on_ground, 0) << i;
    }
}

TEST(MeasuringRays, push_nothing_in_contacts_of_the_world)
{
    Sim sim;
    dWorldSetContactSpace(sim.world, sim.space);
    dWorldSetGravity(sim.world, 0, 0, 0);
    const dBodyID ball = sim.sphere({0, 0, 0}, 0.5, 1);
    ray_in_transform(sim.space, -2, 1.8);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(dWorldStepFast1(sim.world, real(0.01), 4), 1);
    EXPECT_EQ(length(velocity(ball)), 0);
    EXPECT_EQ(length(position(ball)), 0);
}

TEST(MeasuringRays, are_nothing_that_sensors_report)
{
    Sim sim;
    dWorldSetContactSpace(sim.world, sim.space);
    dEventSettings events;
    dEventSettingsInit(&events, sizeof events);
    events.kinds = 1u << dEventSensorBegin;
    ASSERT_EQ(dWorldSetEventSettings(sim.world, &events), 1);
    const dGeomID sensor = dCreateSphere(sim.space, 1), ray = ray_in_transform(sim.space, -2, 4);
    dGeomSetSensor(sensor, 1);
    dGeomSetBody(ray, dBodyCreate(sim.world));
    ASSERT_EQ(dWorldStep(sim.world, real(0.01)), 1);
    EXPECT_EQ(dWorldGetEvents(sim.world, nullptr, 0), 0);
}

}  // namespace
}  // namespace epode::physics
