// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Laws of contacts, limits, friction and servos, in closed form.
#include "models.h"

namespace epode::tests {
namespace {

constexpr double kG = 9.81;

// A sphere of a kilogram on a floor, pushed by forces along its free joint.
const char* const kBall = R"(<mujoco><worldbody><geom type="plane" size="5 5 1" friction="0.5"/>
<body pos="0 0 0.1"><freejoint/><geom type="box" size="0.1 0.1 0.1" mass="1" friction="0.5"/></body></worldbody></mujoco>)";

TEST(BatchLaws, what_stands_is_carried)
{
    const dRobotModelID model = model_of(kWalker);
    Copies<double> copies(model, 3, dReal(0.004), dReal(1e-10), 1, 2000);
    dBatchStep(copies.id, 3000);
    const auto forces = copies.read(dBatchConstraintForces, 0, 1);
    std::vector<dRobotLink> links(size_t(dRobotModelGetLinks(model, nullptr, 0)));
    dRobotModelGetLinks(model, links.data(), int(links.size()));
    double mass = 0, carried = 0;
    for (const dRobotLink& link : links) mass += double(link.mass);
    // The walker's contacts come first, three numbers each.
    const size_t contacts = (forces.size() - 8) / 3;
    for (size_t i = 0; i < contacts; ++i) carried += forces[3 * i];
    EXPECT_NEAR(carried, mass * kG, 1e-6 * mass * kG);
    dRobotModelDestroy(model);
}

// Below mu m g a box stays where it is, above it slides with (f - mu m g) / m, in every direction.
TEST(BatchLaws, friction_holds_to_its_cone_in_every_direction)
{
    const dRobotModelID model = model_of(kBall);
    constexpr int kDirections = 16;
    Copies<double> copies(model, 2 * kDirections, dReal(0.002), dReal(1e-9), 1, 1000);
    dBatchStep(copies.id, 300);
    const double bound = 0.5 * kG;
    for (int i = 0; i < 2 * kDirections; ++i) {
        const double angle = 2 * 3.14159265358979 * i / kDirections,
                     f = bound * (i < kDirections ? 0.999 : 1.01);
        copies.write_one(dBatchAppliedForces, i, {f * std::cos(angle), f * std::sin(angle), 0, 0, 0, 0});
    }
    // Forces act on the centre, friction below it: the box is wide enough not to tip.
    dBatchStep(copies.id, 500);
    const auto v = copies.read(dBatchVelocities);
    for (int i = 0; i < 2 * kDirections; ++i) {
        const double speed = std::hypot(v[size_t(6 * i)], v[size_t(6 * i + 1)]);
        if (i < kDirections) {
            EXPECT_LT(speed, 1e-6) << i;
        } else {
            EXPECT_NEAR(speed, 0.01 * bound * 500 * 0.002, 1e-3 * 0.01 * bound + 1e-5) << i;
        }
    }
    dRobotModelDestroy(model);
}

// What each copy has of its own acts as if the model had it.
TEST(BatchLaws, copies_have_numbers_of_their_own)
{
    const dRobotModelID model = model_of(kBall);
    Copies<double> copies(model, 3, dReal(0.002), dReal(1e-9));
    const std::vector<double> gravity = {0, 0, -kG, 0, 0, -1.62, 0, 0, -kG}, masses = {0, 1, 0, 1, 0, 2};
    ASSERT_EQ(dBatchGetParameterSize(copies.id, dBatchGravity), 3);
    ASSERT_EQ(dBatchGetParameterSize(copies.id, dBatchMasses), 2);
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchGravity, 0, 3, gravity.data()), 1);
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchMasses, 0, 3, masses.data()), 1);
    std::vector<double> read(9);
    EXPECT_EQ(dBatchReadParameter(copies.id, dBatchGravity, 0, 3, read.data()), 1);
    EXPECT_EQ(read, gravity);
    const double mu = 0.25, bad = -1;
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchFrictions, 2, 1, &mu), 1);
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchFrictions, 2, 1, &bad), 0);
    dBatchStep(copies.id, 300);
    copies.write(dBatchAppliedForces, {6, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0});
    dBatchStep(copies.id, 500);
    const auto v = copies.read(dBatchVelocities);
    EXPECT_NEAR(v[0], 6 - 0.5 * kG, 0.01);          // a second with mu m g taken off
    EXPECT_NEAR(v[6], 6 - 0.5 * 1.62, 0.01);        // on the moon
    EXPECT_NEAR(v[12], 6 / 2.0 - 0.25 * kG, 0.01);  // twice the mass, half the friction
    dRobotModelDestroy(model);
}

TEST(BatchLaws, dry_friction_limits_and_servos_keep_their_bounds)
{
    const char* text = R"(<mujoco><compiler angle="radian"/><option gravity="0 0 0"/><worldbody>
<body name="x"><joint name="dry" type="slide" axis="1 0 0" frictionloss="2"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>
<body name="y"><joint name="stop" type="slide" axis="1 0 0" limited="true" range="-0.1 0.2"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>
<body name="z"><joint name="servo" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/></body></worldbody>
<actuator><position joint="servo" kp="1000" forcerange="-3 3"/></actuator></mujoco>)";
    const dRobotModelID model = model_of(text);
    const double h = 0.002;
    Copies<double> copies(model, 2, dReal(h), dReal(1e-12));
    copies.write_one(dBatchAppliedForces, 0, {1.9, 5, 0});
    copies.write_one(dBatchAppliedForces, 1, {3, -5, 0});
    copies.write(dBatchControls, {1, 1});
    dBatchStep(copies.id, 100);
    auto q = copies.read(dBatchPositions), v = copies.read(dBatchVelocities);
    EXPECT_NEAR(v[0], 0, 1e-12);                 // dry friction holds
    EXPECT_NEAR(v[3], (3 - 2) * 100 * h, 1e-9);  // and slides with its bound taken off
    EXPECT_NEAR(v[2], 3.0 / 2 * 100 * h, 1e-9);  // the servo pulls with its limit
    dBatchStep(copies.id, 400);
    q = copies.read(dBatchPositions), v = copies.read(dBatchVelocities);
    EXPECT_NEAR(q[1], 0.2, 1e-9);
    EXPECT_NEAR(q[4], -0.1, 1e-9);
    EXPECT_NEAR(v[1], 0, 1e-9);
    EXPECT_NEAR(v[4], 0, 1e-9);
    dRobotModelDestroy(model);
}

// Round on round and round on box: two bodies on one vertical rail, the upper falls on the lower, and both stand.
TEST(BatchLaws, shapes_of_all_pairs_stand_on_one_another)
{
    const char* shapes[] = {R"(type="sphere" size="0.1")", R"(type="capsule" size="0.1 0.2" euler="0 90 0")",
                            R"(type="capsule" size="0.1 0.2" euler="90 0 0")",
                            R"(type="box" size="0.2 0.2 0.1")"};
    const int pairs[][2] = {{0, 0}, {0, 1}, {1, 0}, {1, 2}, {0, 3}};
    for (const auto& pair : pairs) {
        const std::string text = std::string("<mujoco><worldbody><body><geom ") + shapes[pair[1]] +
                                 R"(/></body><body pos="0 0 0.3"><joint type="slide" axis="0 0 1"/><geom )" +
                                 shapes[pair[0]] + "/></body></worldbody></mujoco>";
        const dRobotModelID model = model_of(text.c_str());
        Copies<double> copies(model, 1, dReal(0.002));
        ASSERT_TRUE(copies.id) << text;
        dBatchStep(copies.id, 1000);
        EXPECT_NEAR(copies.read(dBatchPositions)[0], -0.1, 1e-4) << text;
        EXPECT_NEAR(copies.read(dBatchVelocities)[0], 0, 1e-6) << text;
        dRobotModelDestroy(model);
    }
}

TEST(BatchLaws, shapes_of_all_kinds_stand_on_a_plane)
{
    const struct {
        const char* shape;
        double height;
    } cases[] = {{R"(type="sphere" size="0.1")", 0.1},
                 {R"(type="capsule" size="0.1 0.2" euler="0 90 0")", 0.1},
                 {R"(type="box" size="0.2 0.3 0.1")", 0.1},
                 {R"(type="cylinder" size="0.1 0.15")", 0.15},
                 {R"(type="cylinder" size="0.1 0.15" euler="90 0 0")", 0.1},
                 {R"(type="ellipsoid" size="0.2 0.2 0.1")", 0.1}};
    for (const auto& its : cases) {
        const std::string text =
            std::string(
                R"(<mujoco><worldbody><geom type="plane" size="5 5 1"/><body pos="0 0 0.25"><freejoint/><geom )") +
            its.shape + R"( mass="1"/></body></worldbody></mujoco>)";
        const dRobotModelID model = model_of(text.c_str());
        Copies<double> copies(model, 1, dReal(0.002));
        ASSERT_TRUE(copies.id) << text;
        dBatchStep(copies.id, 1000);
        EXPECT_NEAR(copies.read(dBatchPositions)[2], its.height, 1e-4) << text;
        EXPECT_NEAR(copies.read(dBatchVelocities)[2], 0, 1e-5) << text;
        dRobotModelDestroy(model);
    }
}

}  // namespace
}  // namespace epode::tests
