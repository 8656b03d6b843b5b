// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Scenes on which no threshold was ever tuned. Healthy ones, from other tests, in all steppers: nothing above a
// note. And what users do wrong, in scenes of some size: the cause comes first.
#include <algorithm>
#include <cmath>
#include <functional>

#include "../physics/scenes.h"

namespace epode::physics {
namespace {

std::vector<dDiagnosis> causes_of(const Sim& sim)
{
    std::vector<dDiagnosis> all(64);
    all.resize(std::size_t(dWorldDiagnose(sim.world, all.data(), 64)));
    return all;
}

std::string list_of(const std::vector<dDiagnosis>& causes)
{
    std::string list;
    for (const dDiagnosis& cause : causes) {
        char line[512];
        dDiagnosisText(&cause, line, sizeof line);
        list += std::string(line) + "\n";
    }
    return list;
}

void expect_healthy(const Sim& sim)
{
    const auto causes = causes_of(sim);
    int worst = dSeverityNote;
    for (const dDiagnosis& cause : causes) worst = std::max(worst, cause.severity);
    EXPECT_EQ(worst, dSeverityNote) << list_of(causes);
}

void expect_first(const Sim& sim, dDiagnosisKind kind)
{
    const auto causes = causes_of(sim);
    ASSERT_FALSE(causes.empty()) << "nothing was found";
    EXPECT_EQ(causes[0].kind, kind) << list_of(causes);
    EXPECT_GE(causes[0].severity, dSeverityWarning) << list_of(causes);
}

// ---- healthy: scenes of the tests of physics, nine ways, and six more

class FreshHealthy : public testing::TestWithParam<Stepper> {
  protected:
    FreshHealthy() { dWorldSetDiagnosisMode(sim.world, 1); }

    // Gravity, a floor and pyramids of friction.
    void on_ground(double mu)
    {
        sim.gravity(0, 0, -9.81);
        sim.surface.mode = dContactApprox1;
        sim.surface.mu = real(mu);
        sim.ground();
    }

    Sim sim{GetParam()};
};

TEST_P(FreshHealthy, a_pile_has_no_findings)
{
    on_ground(0.6);
    Random random(8);
    for (int i = 0; i < 40; ++i) {
        const V3 size = {random.uniform(0.2, 0.5), random.uniform(0.2, 0.5), random.uniform(0.2, 0.5)};
        const V3 at = random.point(0.2) + V3{0.8 * (i % 3), 0.8 * (i / 3 % 3), 0.5 + 0.9 * (i / 9)};
        i % 4 ? sim.box(at, size, 2) : sim.sphere(at, 0.2, 2);
    }
    sim.steps(250, 0.01);
    expect_healthy(sim);
}

// The pile of the other tests begins in overlap, and that is reported.
TEST_P(FreshHealthy, but_for_the_pile_that_begins_in_overlap)
{
    build(sim, Scene::kPile);
    sim.steps(20, 0.01);
    const auto causes = causes_of(sim);
    ASSERT_FALSE(causes.empty());
    EXPECT_EQ(causes[0].kind, dDiagnosisOverlap) << list_of(causes);
}

TEST_P(FreshHealthy, a_machine_has_no_findings)
{
    build(sim, Scene::kMachine);
    sim.steps(steps_of(Scene::kMachine), 0.01);
    expect_healthy(sim);
}

TEST_P(FreshHealthy, a_wall_has_no_findings)
{
    build(sim, Scene::kWall);
    sim.steps(steps_of(Scene::kWall), 0.01);
    expect_healthy(sim);
}

TEST_P(FreshHealthy, rolling_and_tumbling_bodies)
{
    on_ground(1);
    velocity(sim.sphere({0, 0, 0.3}, 0.3, 1), {3, 0, 0}, {0, 10, 0});
    velocity(sim.capsule({0, 3, 1}, 0.2, 0.6, 2), {1, 1, 0}, {3, 2, 1});
    velocity(sim.box({0, 6, 1}, {0.4, 0.6, 0.3}, 3), {2, 0, 0}, {4, 1, 2});
    velocity(sim.cylinder({0, 9, 0.6}, 0.3, 0.5, 2), {0, 1, 0}, {2, 0, 3});
    sim.steps(300, 0.01);
    expect_healthy(sim);
}

TEST_P(FreshHealthy, bridge_of_planks_with_a_load)
{
    sim.gravity(0, 0, -9.81);
    dBodyID before = nullptr;
    for (int i = 0; i <= 10; ++i) {
        const dBodyID plank = i < 10 ? sim.box({i + 0.5, 0, 3}, {0.9, 2, 0.1}, 20) : nullptr;
        const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
        if (before && plank)
            dJointAttach(hinge, before, plank);
        else
            dJointAttach(hinge, plank ? plank : before, nullptr);
        dJointSetHingeAnchor(hinge, real(i), 0, 3);
        dJointSetHingeAxis(hinge, 0, 1, 0);
        before = plank;
    }
    sim.surface.mode = dContactApprox1;
    sim.surface.mu = real(0.8);
    sim.box({5, 0, 3.5}, {0.8, 0.8, 0.8}, 60);
    sim.steps(300, 0.005);
    expect_healthy(sim);
}

TEST_P(FreshHealthy, motors_against_their_stops)
{
    sim.gravity(0, 0, -9.81);
    for (int i = 0; i < 4; ++i) {
        const dBodyID arm = sim.box({3.0 * i + 0.5, 0, 2}, {1, 0.2, 0.2}, 2);
        const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinge, arm, nullptr);
        dJointSetHingeAnchor(hinge, real(3.0 * i), 0, 2);
        dJointSetHingeAxis(hinge, 0, 1, 0);
        dJointSetHingeParam(hinge, dParamVel, real(i % 2 ? 2 : -2));
        dJointSetHingeParam(hinge, dParamFMax, 40);
        dJointSetHingeParam(hinge, dParamLoStop, real(-0.8));
        dJointSetHingeParam(hinge, dParamHiStop, real(0.8));
    }
    sim.steps(300, 0.01);
    expect_healthy(sim);
}

// ---- healthy, and written after the last threshold was set

TEST_P(FreshHealthy, seesaw_that_a_weight_falls_on)
{
    on_ground(0.7);
    const dBodyID board = sim.box({0, 0, 0.6}, {4, 0.5, 0.08}, 20);
    const dJointID pivot = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(pivot, board, nullptr);
    dJointSetHingeAnchor(pivot, 0, 0, real(0.6));
    dJointSetHingeAxis(pivot, 0, 1, 0);
    sim.box({-1.7, 0, 0.9}, {0.4, 0.4, 0.4}, 5);
    sim.sphere({1.7, 0, 3}, 0.2, 15);
    sim.steps(300, 0.01);
    expect_healthy(sim);
}

TEST_P(FreshHealthy, mill_with_motors_and_balls)
{
    on_ground(0.3);
    for (int i = 0; i < 3; ++i) {
        const dBodyID blade = sim.box({2.0 * i, 0, 1.2}, {1.6, 0.4, 0.1}, 8);
        const dJointID axle = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(axle, blade, nullptr);
        dJointSetHingeAnchor(axle, real(2.0 * i), 0, real(1.2));
        dJointSetHingeAxis(axle, 0, 1, 0);
        dJointSetHingeParam(axle, dParamVel, real(i % 2 ? 3 : -3));
        dJointSetHingeParam(axle, dParamFMax, 60);
        for (int k = 0; k < 4; ++k) sim.sphere({2.0 * i + 0.3 * k - 0.4, 0, 2.6 + 0.5 * k}, 0.15, 1);
    }
    sim.steps(400, 0.01);
    expect_healthy(sim);
}

TEST_P(FreshHealthy, dominoes_in_a_curve)
{
    on_ground(0.5);
    for (int i = 0; i < 16; ++i) {
        const dBodyID tile = sim.box({0.25 * i, 0.01 * i * i, 0.3}, {0.06, 0.3, 0.6}, 1);
        dMatrix3 R;
        dRFromAxisAndAngle(R, 0, 0, 1, real(0.05 * i));
        dBodySetRotation(tile, R);
    }
    velocity(sim.sphere({-0.5, 0, 0.5}, 0.1, 1), {2, 0, 0});
    sim.steps(400, 0.005);
    expect_healthy(sim);
}

TEST_P(FreshHealthy, slider_crank_and_flywheel)
{
    const dBodyID wheel = sim.cylinder({0, 0, 0}, 0.4, 0.1, 20),
                  rod = sim.box({0.8, 0, 0}, {1, 0.05, 0.05}, 1),
                  piston = sim.box({1.3, 0, 0}, {0.2, 0.2, 0.2}, 2);
    const auto hinge = [&](dBodyID a, dBodyID b, double x) {
        const dJointID joint = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(joint, a, b);
        dJointSetHingeAnchor(joint, real(x), 0, 0);
        dJointSetHingeAxis(joint, 0, 0, 1);
        return joint;
    };
    const dJointID axle = hinge(wheel, nullptr, 0);
    hinge(rod, wheel, 0.3), hinge(piston, rod, 1.3);
    const dJointID guide = dJointCreateSlider(sim.world, nullptr);
    dJointAttach(guide, piston, nullptr);
    dJointSetSliderAxis(guide, 1, 0, 0);
    dJointSetHingeParam(axle, dParamVel, 6);
    dJointSetHingeParam(axle, dParamFMax, 30);
    for (int i = 0; i < 600; ++i) sim.advance(0.005);
    expect_healthy(sim);
}

TEST_P(FreshHealthy, trailer_on_springs_of_the_library)
{
    on_ground(1);
    const dBodyID chassis = sim.box({0, 0, 0.7}, {2, 1, 0.2}, 200);
    for (int i = 0; i < 4; ++i) {
        const double x = i < 2 ? 0.8 : -0.8, y = i % 2 ? 0.7 : -0.7;
        const dBodyID wheel = sim.sphere({x, y, 0.3}, 0.3, 15);
        const dJointID leg = dJointCreateHinge2(sim.world, nullptr);
        const dReal up[3] = {0, 0, 1}, axle[3] = {0, 1, 0};
        dJointAttach(leg, chassis, wheel);
        dJointSetHinge2Anchor(leg, real(x), real(y), real(0.3));
        dJointSetHinge2Axes(leg, up, axle);
        dJointSetHinge2Param(leg, dParamSuspensionERP, real(0.4));
        dJointSetHinge2Param(leg, dParamSuspensionCFM, real(1e-4));
        dJointSetHinge2Param(leg, dParamLoStop, 0);
        dJointSetHinge2Param(leg, dParamHiStop, 0);
    }
    velocity(chassis, {4, 0, 0});
    sim.steps(400, 0.005);
    expect_healthy(sim);
}

INSTANTIATE_TEST_SUITE_P(AllSteppers, FreshHealthy, testing::ValuesIn(kSteppers), case_name);

TEST(FreshHealthyWorlds, game_of_the_defaults)
{
    Sim sim;
    dWorldUseDefaults(sim.world, dDefaultsGame);
    dWorldSetContactSpace(sim.world, sim.space);
    dWorldSetDiagnosisMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    sim.ground();
    for (int i = 0; i < 12; ++i) sim.box({0, 0, 0.5 + i}, {1, 1, 1}, 100);
    for (int i = 0; i < 30; ++i)
        sim.box({6 + 0.1 * (i % 3), 0.1 * (i % 5), 1 + 0.6 * i}, {0.4, 0.5, 0.6}, 20);
    for (int i = 0; i < 600; ++i) dWorldStepHybrid(sim.world, real(1.0 / 60));
    expect_healthy(sim);
}

TEST(FreshHealthyWorlds, robot_of_the_defaults)
{
    Sim sim;
    dWorldUseDefaults(sim.world, dDefaultsRobot);
    dWorldSetDiagnosisMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    std::vector<dJointID> hinges;
    for (int i = 0; i < 6; ++i) {
        const dBodyID before = i ? sim.bodies.back() : nullptr;
        const dBodyID link = sim.box({0.15 + 0.3 * i, 0, 0}, {0.3, 0.08, 0.06}, 3 - 0.4 * i);
        hinges.push_back(dJointCreateHinge(sim.world, nullptr));
        dJointAttach(hinges.back(), link, before);
        dJointSetHingeAnchor(hinges.back(), real(0.3 * i), 0, 0);
        dJointSetHingeAxis(hinges.back(), 0, 1, 0);
    }
    for (int i = 0; i < 1500; ++i) {
        for (dJointID hinge : hinges) {
            dDrive servo;
            dDriveInit(&servo, sizeof servo);
            servo.stiffness = 2000, servo.damping = 60, servo.target = real(std::min(0.4, 0.5e-3 * i));
            dJointSetDrive(hinge, 0, &servo);
        }
        dWorldStepHybrid(sim.world, real(0.002));
    }
    expect_healthy(sim);
}

TEST(FreshHealthyWorlds, slack_and_taut_rope_of_beads)
{
    Sim sim;
    dWorldSetDiagnosisMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    dBodyID before = nullptr;
    for (int i = 0; i < 25; ++i) {
        const dBodyID bead = sim.sphere({0.2 * i + 0.1, 0, 6}, 0.05, 0.2);
        const dJointID ball = dJointCreateBall(sim.world, nullptr);
        dJointAttach(ball, bead, before);
        dJointSetBallAnchor(ball, real(0.2 * i), 0, 6);
        before = bead;
    }
    sim.steps(400, 0.005);
    expect_healthy(sim);
}

// ---- what users do wrong

TEST(FreshFailing, thrust_in_grams_of_a_rocket)
{
    Sim sim;
    dWorldSetDiagnosisMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    sim.ground();
    sim.box({5, 0, 0.5}, {1, 1, 1}, 10);
    const dBodyID rocket = sim.cylinder({0, 0, 1.1}, 0.2, 2, 50);
    for (int i = 0; i < 30; ++i) {
        dBodyAddForce(rocket, 0, 0, real(1e9));
        sim.step(0.01);
    }
    expect_first(sim, dDiagnosisInput);
}

TEST(FreshFailing, suspension_of_the_program_that_is_too_stiff)
{
    Sim sim(Stepper::kQuick);
    dWorldSetDiagnosisMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    const dBodyID chassis = sim.box({0, 0, 1}, {2, 1, 0.4}, 800);
    for (int i = 0; i < 200; ++i) {
        const double z = dBodyGetPosition(chassis)[2], v = dBodyGetLinearVel(chassis)[2];
        dBodyAddForce(chassis, 0, 0, real(2e7 * (0.99 - z) - 1e5 * v));
        sim.step(0.02);
    }
    expect_first(sim, dDiagnosisStiffSpring);
}

TEST(FreshFailing, crates_poured_into_one_place)
{
    Sim sim(Stepper::kQuick);
    dWorldSetDiagnosisMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    sim.ground();
    for (int i = 0; i < 12; ++i) sim.box({0.05 * i, 0, 0.6 + 0.03 * i}, {1, 1, 1}, 20);
    sim.steps(60, 0.01);
    expect_first(sim, dDiagnosisOverlap);
}

TEST(FreshFailing, door_that_was_moved_between_its_two_hinges)
{
    Sim sim;
    dWorldSetDiagnosisMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    const dBodyID door = sim.box({0.5, 0, 1}, {1, 0.05, 2}, 30);
    for (int i = 0; i < 2; ++i) {
        const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinge, door, nullptr);
        dJointSetHingeAnchor(hinge, 0, 0, real(0.2 + 1.6 * i));
        dJointSetHingeAxis(hinge, 0, 0, 1);
        place(door, {0.55, 0, 1});  // between the two
    }
    sim.steps(200, 0.01);
    expect_first(sim, dDiagnosisContradiction);
}

TEST(FreshFailing, crane_that_lifts_a_ship_with_thin_links)
{
    Sim sim;
    dWorldSetDiagnosisMode(sim.world, 1);
    dWorldSetBehaviour(sim.world,
                       dBehaviour016);  // the newest holds them (step/island/positions/tension.cpp)
    sim.gravity(0, 0, -9.81);
    dBodyID before = nullptr;
    for (int i = 0; i < 7; ++i) {
        const bool last = i == 6;
        const dBodyID link = last ? sim.box({3.5, 0, 10}, {1, 1, 1}, 4000)
                                  : sim.box({0.25 + 0.5 * i, 0, 10}, {0.5, 0.04, 0.04}, 1);
        const dJointID ball = dJointCreateBall(sim.world, nullptr);
        dJointAttach(ball, link, before);
        dJointSetBallAnchor(ball, real(0.5 * i), 0, 10);
        before = link;
    }
    sim.steps(150, 0.01);
    expect_first(sim, dDiagnosisStepTooLong);
}

TEST(FreshFailing, hail_through_a_roof)
{
    Sim sim(Stepper::kQuick);
    dWorldSetDiagnosisMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    dGeomSetPosition(dCreateBox(sim.space, 10, 10, real(0.01)), 0, 0, 3);
    for (int i = 0; i < 5; ++i) velocity(sim.sphere({real(i) - 2.0, 0, 4.0}, 0.02, 0.03), {0, 0, -90});
    sim.steps(3, 0.02);
    expect_first(sim, dDiagnosisTunnelling);
}

}  // namespace
}  // namespace epode::physics
