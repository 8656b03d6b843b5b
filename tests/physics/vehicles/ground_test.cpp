// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What wheels stand on: kerbs, slopes, meshes, belts, platforms that move, sleepers.
#include "road.h"

#ifdef dIDEDOUBLE  // the bounds are those of doubles

namespace epode::vehicles {
namespace {

// A kerb of 10 cm: every kind of wheel gets up, at the speed of a walk.
TEST(Ground, is_climbed_over_kerbs_by_every_kind_of_wheel)
{
    for (const int cast : {dWheelRay, dWheelSphere, dWheelCylinder}) {
        Road road;
        road.flat();
        dGeomSetPosition(dCreateBox(road.space, 20, 20, 1), 13, 0, dReal(-0.4));
        Wheels wheels;
        wheels.like.cast = cast;
        const dBodyID car = road.car(wheels, plain_settings(), 3);
        dVehicleSetGear(car, 0);
        double fastest = 0;
        for (int i = 0; i < 60 * 3; ++i) {
            road.run(car, 1.0 / 60, 1.0 / 60);
            fastest = std::max(fastest, std::fabs(double(dBodyGetLinearVel(car)[2])));
        }
        EXPECT_GT(x_of(car), 5) << cast;
        EXPECT_NEAR(z_of(car), Road::height(wheels.like) + 0.1, 0.01) << cast;
        EXPECT_LT(fastest, 1.5) << cast;  // it is not thrown
    }
}

// On a plane the three are the same wheel, whatever the slope along and across.
TEST(Ground, is_the_same_plane_for_every_kind_of_wheel)
{
    for (const int cast : {dWheelRay, dWheelSphere, dWheelCylinder}) {
        Road road;
        dCreatePlane(road.space, dReal(-0.2), 0, dReal(0.98), 0);
        Wheels wheels;
        wheels.like.cast = cast;
        const dBodyID car = road.car(wheels);
        drive(car, 0, 1);
        dBodySetPosition(car, 0, 0, dReal(0.9));
        road.run(car, 5, 1.0 / 60);
        for (int i = 0; i < 4; ++i) {
            const dVehicleWheelReport w = wheel(car, i);
            const double off = -0.2 * w.hub[0] + 0.98 * w.hub[2];
            EXPECT_NEAR(off / std::hypot(0.2, 0.98), kRadius, 2e-3) << cast;
            EXPECT_NEAR(w.ground_normal[0], -0.2 / std::hypot(0.2, 0.98), 1e-6) << cast;
        }
        EXPECT_LT(speed(car), 1e-4) << cast;
    }
}

TEST(Ground, may_be_a_mesh_whose_triangle_is_reported)
{
    Road road;
    static const float points[] = {-50, -50, 0, 50, -50, 0, 50, 50, 0, -50, 50, 0};
    static const dTriIndex corners[] = {0, 1, 2, 0, 2, 3};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(data, points, 3 * sizeof(float), 4, corners, 6, 3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(road.space, data, nullptr, nullptr, nullptr);
    const dBodyID car = road.car();
    dBodySetPosition(car, 5, 20, z_of(car));
    road.run(car, 1, 1.0 / 60);
    EXPECT_EQ(wheel(car, 0).ground, mesh);
    EXPECT_EQ(wheel(car, 0).ground_side, 1);
    dBodySetPosition(car, 20, -20, z_of(car));
    road.run(car, 0.1, 1.0 / 60);
    EXPECT_EQ(wheel(car, 0).ground_side, 0);
    dBodySetPosition(car, 0, 0, 50);
    road.run(car, 0.1, 1.0 / 60);
    EXPECT_EQ(wheel(car, 0).ground, nullptr);
    EXPECT_EQ(report(car).wheels_on_ground, 0);
    dGeomDestroy(mesh), dGeomTriMeshDataDestroy(data);
}

// A belt that runs backwards carries the car away; a rolling road turns its wheels.
TEST(Ground, carries_with_its_surface_velocity)
{
    for (const bool brakes : {true, false}) {
        Road road;
        const dGeomID belt = dCreateBox(road.space, 400, 10, 1);
        dGeomSetPosition(belt, 0, 0, dReal(-0.5));
        dMaterial m;
        dMaterialInit(&m, sizeof m);
        m.surface_velocity[0] = -4;
        dGeomSetMaterial(belt, &m);
        const dBodyID car = road.car();
        dVehicleSetGear(car, 0);
        drive(car, 0, brakes);
        road.run(car, 4, 1.0 / 60);
        // Rolling freely, it has only to turn its wheels.
        EXPECT_NEAR(dBodyGetLinearVel(car)[0],
                    brakes ? -4 : -4 * 4 / (kRadius * kRadius) / (kMass + 4 / (kRadius * kRadius)), 0.02);
        EXPECT_NEAR(wheel(car, 0).spin, brakes ? 0 : (4 + dBodyGetLinearVel(car)[0]) / kRadius, 0.05);
    }
}

// A lorry whose platform it stands on: the parked car goes with it, and wakes when that starts.
TEST(Ground, takes_a_parked_car_along)
{
    Road road(0, dDefaultsGame);
    dWorldSetAutoDisableFlag(road.world, 1);
    const dBodyID lorry = dBodyCreate(road.world);
    dBodySetKinematic(lorry);
    dGeomSetBody(dCreateBox(road.space, 30, 10, 1), lorry);
    dBodySetPosition(lorry, 0, 0, dReal(-0.5));
    const dBodyID car = road.car();
    drive(car, 0, 1);
    road.run(car, 8, 1.0 / 60);
    EXPECT_EQ(dBodyIsEnabled(car), 0);
    dBodySetLinearVel(lorry, 0, 0, 0);
    for (int i = 0; i < 120; ++i) {
        dBodySetLinearVel(lorry, dReal(std::min(i / 30.0, 2.0)), 0, 0);
        road.run(car, 1.0 / 60, 1.0 / 60);
    }
    EXPECT_EQ(dBodyIsEnabled(car), 1);
    EXPECT_NEAR(dBodyGetLinearVel(car)[0], 2, 0.02);
    EXPECT_NEAR(x_of(car) - dBodyGetPosition(lorry)[0], 0, 0.05);
}

// A plank on two trestles that has fallen asleep feels the car that drives onto it.
TEST(Ground, wakes_when_a_car_drives_onto_it)
{
    Road road(0, dDefaultsGame);
    road.flat();
    dWorldSetAutoDisableFlag(road.world, 1);
    const dBodyID seesaw = dBodyCreate(road.world);
    dMass m;
    dMassSetBoxTotal(&m, 200, 8, 3, dReal(0.1));
    dBodySetMass(seesaw, &m);
    dGeomSetBody(dCreateBox(road.space, 8, 3, dReal(0.1)), seesaw);
    dBodySetPosition(seesaw, 8, 0, dReal(0.05));
    const dBodyID car = road.car();
    drive(car, 0, 1);
    road.run(car, 6, 1.0 / 60);
    EXPECT_EQ(dBodyIsEnabled(seesaw), 0);
    EXPECT_EQ(dBodyIsEnabled(car), 0);
    drive(car, 0.3);
    bool woken = false;
    for (int i = 0; i < 240; ++i) {
        road.run(car, 1.0 / 60, 1.0 / 60);
        woken = woken || dBodyIsEnabled(seesaw);
    }
    EXPECT_TRUE(woken);
    EXPECT_GT(x_of(car), 5);
}

// Not its own geoms, no sensors, and only what its bits agree with.
TEST(Ground, is_not_what_the_bits_leave_out)
{
    Road road;
    road.flat();
    const dGeomID glass = dCreateBox(road.space, 10, 10, dReal(0.2));
    dGeomSetCategoryBits(glass, 2), dGeomSetCollideBits(glass, 2);
    const dGeomID sensor = dCreateBox(road.space, 10, 10, dReal(0.2));
    dGeomSetSensor(sensor, 1);
    dVehicleSettings s = plain_settings();
    s.category_bits = s.collide_bits = ~2ul;
    const dBodyID car = road.car({}, s);
    road.run(car, 2, 1.0 / 60);
    EXPECT_NEAR(z_of(car), Road::height(Wheels().like), 0.3);
    EXPECT_NEAR(wheel(car, 0).ground_pos[2], 0, 1e-9);
}

TEST(Ground, does_not_hold_what_flies)
{
    Road road;
    road.flat();
    const dBodyID car = road.car({}, plain_settings(), 10);
    dBodySetPosition(car, 0, 0, 20);
    road.run(car, 1, 1.0 / 60);
    EXPECT_NEAR(dBodyGetLinearVel(car)[2], -kG, 1e-9);
    EXPECT_NEAR(dBodyGetLinearVel(car)[0], 10, 1e-9);
}

// As long as nobody works it, it costs a look and no bits.
TEST(Ground, lets_a_sleeping_vehicle_lie)
{
    Road road(0, dDefaultsGame);
    road.flat();
    dWorldSetAutoDisableFlag(road.world, 1);
    const dBodyID car = road.car();
    drive(car, 0, 1);
    road.run(car, 8, 1.0 / 60);
    ASSERT_EQ(dBodyIsEnabled(car), 0);
    const double z = z_of(car);
    EXPECT_EQ(dVehicleUpdate(car, dReal(0.01)), 4);
    road.run(car, 10, 1.0 / 60);
    EXPECT_EQ(z_of(car), z);
    EXPECT_EQ(dBodyIsEnabled(car), 0);
    EXPECT_NEAR(wheel(car, 1).load, kMass * kG / 4, 1e-3 * kMass * kG);
}

}  // namespace
}  // namespace epode::vehicles
#endif
