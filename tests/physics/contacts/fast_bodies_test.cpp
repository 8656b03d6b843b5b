// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What lies down, lands on one end, or is so fast that a step takes it through: in the presets, on every kind of ground.
#include <algorithm>
#include <array>
#include <string>

#include "../mesh_floors.h"

namespace epode::physics {
namespace {

constexpr Floor kFloors[] = {Floor::kPlane, Floor::kBox, Floor::kMesh, Floor::kTwoMeshes, Floor::kField};
constexpr int kPresets[] = {dDefaultsGame, dDefaultsRobot};

enum class Shape { kBall, kCapsule, kCylinder, kCube, kRod };
const char* name_of(Shape shape)
{
    constexpr const char* kNames[] = {"ball", "capsule", "cylinder", "cube", "rod"};
    return kNames[int(shape)];
}

// 10 cm thick, `length` in all along its z axis.
dBodyID add(Sim& sim, Shape shape, V3 at, double length)
{
    constexpr double r = 0.05;
    switch (shape) {
        case Shape::kBall:
            return sim.sphere(at, r, 2);
        case Shape::kCapsule:
            return sim.capsule(at, r, length - 2 * r, 2);
        case Shape::kCylinder:
            return sim.cylinder(at, r, length, 2);
        case Shape::kCube:
            return sim.box(at, {2 * r, 2 * r, 2 * r}, 2);
        default:
            return sim.box(at, {2 * r, 2 * r, length}, 2);
    }
}

void turn(dBodyID body, V3 axis, double angle)
{
    dMatrix3 R;
    dRFromAxisAndAngle(R, real(axis.x), real(axis.y), real(axis.z), real(angle));
    dBodySetRotation(body, R);
}

void prepare(Sim& sim, int preset)
{
    dWorldUseDefaults(sim.world, preset);
    dWorldSetContactSpace(sim.world, sim.space);
    dWorldSetAutoDisableFlag(sim.world, 0);
    sim.gravity(0, 0, -9.81);
}

// By the corners of a box, the rims of a cylinder, the ends of a capsule.
double lowest_point(dBodyID body, Shape shape, double length)
{
    const dReal* R = dBodyGetRotation(body);
    constexpr double r = 0.05;
    const double slope = std::fabs(double(R[10])), z = position(body).z;
    if (shape == Shape::kCapsule) return z - slope * (length / 2 - r) - r;
    if (shape == Shape::kCylinder)
        return z - slope * length / 2 - r * std::sqrt(std::max(0.0, 1 - slope * slope));
    return z - slope * length / 2 - r * (std::fabs(double(R[8])) + std::fabs(double(R[9])));
}

// Rounding makes one end the lower one, which alone touches: the other end fell by 2 mm, and the body had turned at 1 rad/s.
TEST(FastBodies, what_is_put_down_lying_lies)
{
    for (const int preset : kPresets)
        for (const Floor floor : kFloors)
            for (const double h : {1.0 / 60, 1.0 / 240, 1e-3})
                for (const Shape shape : {Shape::kCapsule, Shape::kCylinder, Shape::kRod}) {
                    Sim sim;
                    prepare(sim, preset);
                    const FlatGround ground(sim, floor, 4, 2);
                    const dBodyID body = add(sim, shape, {0.3, 0.2, 0.05}, 0.3);
                    turn(body, {1, 0, 0}, kPi / 2);
                    double fastest = 0;
                    for (int i = 0; i < 60; ++i) {
                        ASSERT_TRUE(dWorldStepHybrid(sim.world, real(h)));
                        fastest = std::max(fastest, length(spin(body)));
                    }
                    const V3 way = position(body) - V3{0.3, 0.2, 0.05};
                    EXPECT_LT(fastest, tol(1e-3, 1e-2))
                        << name_of(floor) << " " << name_of(shape) << " " << preset << " " << h;
                    EXPECT_LT(std::hypot(way.x, way.y), tol(1e-6, 1e-5))
                        << name_of(floor) << " " << name_of(shape) << " " << preset << " " << h;
                }
}

// The end that lands first stops, and the other one comes down at more than the speed of the fall. (It sank in by up to 153 mm,
// and through meshes.)
TEST(FastBodies, a_rod_that_lands_on_one_end_does_not_sink_in)
{
    for (const int preset : kPresets)
        for (const Floor floor : kFloors)
            for (const double tilt : {0.02, 0.2, 0.5})
                for (const Shape shape : {Shape::kCapsule, Shape::kCylinder, Shape::kRod})
                    for (int drop = 0; drop < 6; ++drop) {
                        Sim sim;
                        prepare(sim, preset);
                        const FlatGround ground(sim, floor, 4, 2);
                        const dBodyID body = add(sim, shape, {0.3, 0.2, 2 + 0.017 * drop}, 1);
                        turn(body, {1, 0, 0}, kPi / 2 + tilt);
                        double depth = 0;
                        for (int i = 0; i < 100; ++i) {
                            ASSERT_TRUE(dWorldStepHybrid(sim.world, real(1.0 / 60)));
                            depth = std::max(depth, -lowest_point(body, shape, 1));
                        }
                        EXPECT_LT(depth, 3e-3)
                            << name_of(floor) << " " << name_of(shape) << " " << preset << " " << tilt;
                    }
}

// Twenty bodies, each turned and turning in its own way.
std::array<dBodyID, 20> drop_many(Sim& sim, Shape shape, double height)
{
    std::array<dBodyID, 20> bodies;
    for (int i = 0; i < 20; ++i) {
        const dBodyID body =
            add(sim, shape, {0.3 + 2 * (i % 5), 0.2 + 2 * double(i / 5), height + 0.017 * i}, 0.5);
        turn(body, {std::sin(1.7 * i), std::cos(2.3 * i), std::sin(0.9 * i) + 2}, 1.1 * i);
        velocity(body, {}, {3 * std::sin(i), 3 * std::cos(1.3 * i), 0});
        bodies[std::size_t(i)] = body;
    }
    return bodies;
}

int lost_of(Sim& sim, const std::array<dBodyID, 20>& bodies)
{
    for (int i = 0; i < 240; ++i) dWorldStepHybrid(sim.world, real(1.0 / 60));
    return int(std::count_if(bodies.begin(), bodies.end(), [](dBodyID b) { return position(b).z < -0.2; }));
}

// A ball of 10 cm that has fallen 0.5 m moves by half of its size in a step; a quarter of them was lost. (From 10 m one of forty cylinders is.)
TEST(FastBodies, a_mesh_holds_what_falls_on_it)
{
    for (const int preset : kPresets)
        for (const double height : {0.5, 2.0, 5.0})
            for (const Shape shape :
                 {Shape::kBall, Shape::kCapsule, Shape::kCylinder, Shape::kCube, Shape::kRod}) {
                Sim sim;
                prepare(sim, preset);
                const FlatGround ground(sim, Floor::kMesh, 20, 2);
                EXPECT_EQ(lost_of(sim, drop_many(sim, shape, height)), 0)
                    << name_of(shape) << " " << preset << " " << height;
            }
}

TEST(FastBodies, a_slab_holds_what_falls_on_it)
{
    for (const int preset : kPresets)
        for (const double height : {0.5, 2.0, 5.0})
            for (const Shape shape : {Shape::kBall, Shape::kCapsule, Shape::kCylinder, Shape::kCube}) {
                Sim sim;
                prepare(sim, preset);
                dGeomSetPosition(dCreateBox(sim.space, 40, 40, real(0.02)), 0, 0, real(-0.01));
                EXPECT_EQ(lost_of(sim, drop_many(sim, shape, height)), 0)
                    << name_of(shape) << " " << preset << " " << height;
            }
}

// Floor and wall are one mesh: what touches the floor was not looked for at the wall.
TEST(FastBodies, what_rolls_on_a_mesh_stops_at_its_wall)
{
    for (const int preset : kPresets)
        for (const double speed : {2.0, 5.0, 10.0, 20.0})
            for (const Shape shape :
                 {Shape::kBall, Shape::kCapsule, Shape::kCylinder, Shape::kCube, Shape::kRod}) {
                Sim sim;
                prepare(sim, preset);
                const MeshGeom hall(sim.space, {-50, -50, 0, 0, 10, -50, 0,  0, 10, 50, 0,  0,
                                                -50, 50,  0, 0, 10, -50, 50, 0, 10, 50, 50, 0},
                                    {0, 1, 2, 0, 2, 3, 2, 1, 4, 2, 4, 5});
                for (int i = 0; i < 20; ++i) {
                    const dBodyID body = add(sim, shape, {5 + 0.037 * i, -20.0 + 2 * i, 0.051}, 0.5);
                    turn(body, {1, 0, 0}, kPi / 2);
                    velocity(body, {speed, 0, 0}, shape < Shape::kCube ? V3{0, speed / 0.05, 0} : V3{});
                }
                double farthest = 0;
                for (int i = 0; i < 180; ++i) {
                    ASSERT_TRUE(dWorldStepHybrid(sim.world, real(1.0 / 60)));
                    for (const dBodyID body : sim.bodies) farthest = std::max(farthest, position(body).x);
                }
                EXPECT_LT(farthest, 9.97) << name_of(shape) << " " << preset << " " << speed;
            }
}

}  // namespace
}  // namespace epode::physics
