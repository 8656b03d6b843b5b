// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The energy ledger: each share against the closed form of a scene that has that share alone, in every stepper
// and with contacts of both kinds; errors of the integration vanish with the step; the sum closes everywhere.
#include <algorithm>
#include <cmath>
#include <functional>

#include "scenes.h"
#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81;

enum class Way { kExact, kExactSubsteps, kProjected, kQuick, kSubsteps, kNetwork, kHybrid };
constexpr Way kWays[] = {Way::kExact,    Way::kExactSubsteps, Way::kProjected, Way::kQuick,
                         Way::kSubsteps, Way::kNetwork,       Way::kHybrid};
struct Case {
    Way way;
    bool world_contacts;
};
std::string name_of(const testing::TestParamInfo<Case>& info)
{
    const char* const names[] = {"Exact",    "ExactSubsteps", "Projected", "Quick",
                                 "Substeps", "Network",       "Hybrid"};
    return std::string(names[int(info.param.way)]) + (info.param.world_contacts ? "WorldContacts" : "Joints");
}

// The shares of many steps together.
struct Total {
    double kinetic = 0, gravity = 0, forces = 0, drives = 0, friction = 0, impacts = 0, joints = 0,
           damping = 0, correction = 0, integration = 0, moved = 0;
};

double shares_of(const dEnergyLedger& l)
{
    return l.gravity + l.forces + l.drives + l.friction + l.impacts + l.joints + l.damping + l.correction +
           l.integration;
}

class Ledger : public testing::TestWithParam<Case> {
  protected:
    Ledger() { set_up(sim, GetParam()); }

    static void set_up(Sim& sim, Case how)
    {
        sim.gravity(0, 0, -kG);
        if (how.world_contacts) dWorldSetContactSpace(sim.world, sim.space);
        if (how.way == Way::kExactSubsteps) dWorldSetExactSubsteps(sim.world, 4);
        if (how.way == Way::kProjected) dWorldSetStepProjection(sim.world, 10);
        EXPECT_EQ(dWorldSetEnergyLedgerMode(sim.world, 1), 1);
    }
    static void step(Sim& sim, Case how, double step)
    {
        if (how.world_contacts)
            dJointGroupEmpty(sim.contacts);
        else
            sim.collide();
        const dReal h = real(step);
        const dWorldID world = sim.world;
        const dStepper stepper = how.way == Way::kNetwork ? dStepperSubstepsExactJoints : dStepperSubsteps;
        int made = 0;
        if (how.way <= Way::kProjected)
            made = dWorldStep(world, h);
        else if (how.way == Way::kQuick)
            made = dWorldQuickStep(world, h);
        else if (how.way == Way::kHybrid)
            made = dWorldStepHybrid(world, h);
        else
            dWorldsStep(&world, 1, h, stepper, 5, 1, 1, &made);
        ASSERT_EQ(made, 1);
    }
    static dEnergyLedger ledger_of(const Sim& sim)
    {
        dEnergyLedger l{};
        l.struct_size = sizeof l;
        EXPECT_EQ(dWorldGetEnergyLedger(sim.world, &l), 1);
        return l;
    }
    Total run(
        int steps, const std::function<void()>& before = [] {})
    {
        Total sum;
        for (int i = 0; i < steps; ++i) {
            before();
            step(sim, GetParam(), h);
            add(ledger_of(sim), sum);
        }
        return sum;
    }
    static void add(const dEnergyLedger& l, Total& sum)
    {
        sum.kinetic += l.kinetic_after - l.kinetic_before;
        sum.gravity += l.gravity, sum.forces += l.forces, sum.drives += l.drives, sum.friction += l.friction;
        sum.impacts += l.impacts, sum.joints += l.joints, sum.damping += l.damping;
        sum.correction += l.correction, sum.integration += l.integration;
        const double moved = std::fabs(l.gravity) + std::fabs(l.forces) + std::fabs(l.drives) +
                             std::fabs(l.friction) + std::fabs(l.impacts) + std::fabs(l.joints) +
                             std::fabs(l.damping) + std::fabs(l.correction) + std::fabs(l.integration) +
                             l.kinetic_before + l.kinetic_after;
        sum.moved += moved;
        EXPECT_NEAR(l.kinetic_after - l.kinetic_before, shares_of(l), 1e-12 * moved + 1e-13);
        const double fallen = l.potential_after - l.potential_before;
        EXPECT_NEAR(fallen, -l.gravity, 1e-9 * (std::fabs(l.potential_after) + moved));
    }
    int parts() const
    {
        const Way way = GetParam().way;
        return way == Way::kExactSubsteps ? 4 : way == Way::kSubsteps || way == Way::kNetwork ? 5 : 1;
    }
    bool relaxes() const { return GetParam().way >= Way::kSubsteps; }

    Sim sim;
    double h = 0.01;
};

std::vector<Case> all_cases()
{
    std::vector<Case> out;
    for (const Way way : kWays) out.push_back({way, false}), out.push_back({way, true});
    return out;
}
INSTANTIATE_TEST_SUITE_P(Ways, Ledger, testing::ValuesIn(all_cases()), name_of);

constexpr bool kFloats = sizeof(dReal) == 4;
double close_to(double exact, double in_floats) { return kFloats ? in_floats : exact; }

TEST_P(Ledger, of_a_falling_body_has_gravity_and_the_error_of_the_integration)
{
    const double m = 3;
    const dBodyID ball = sim.sphere({0, 0, 9}, 0.2, m);
    const Total sum = run(20);
    const double fall = 9 - position(ball).z;
    EXPECT_NEAR(sum.gravity, m * kG * fall, close_to(1e-9, 1e-4));
    EXPECT_NEAR(sum.kinetic, kinetic_energy(ball), close_to(1e-9, 1e-4));
    if (GetParam().way != Way::kHybrid) {
        const double exact = -20 * m * kG * kG * h * h / 2 / parts();
        EXPECT_NEAR(sum.integration, exact, close_to(1e-9, 1e-3));
    }
    EXPECT_LT(std::fabs(sum.integration), 0.06 * sum.gravity);
    EXPECT_EQ(sum.forces + sum.friction + sum.impacts + sum.joints + sum.damping + sum.correction, 0);
}

TEST_P(Ledger, forces_of_the_program_work_along_the_path)
{
    sim.gravity(0, 0, 0);
    const dBodyID ball = sim.sphere({0, 0, 0}, 0.2, 2);
    velocity(ball, {0, 1, 0});
    const Total sum = run(30, [&] { dBodyAddForce(ball, 5, 1, 0), dBodyAddTorque(ball, 0, 0, real(0.01)); });
    EXPECT_NEAR(sum.forces, sum.kinetic, close_to(1e-9, 1e-4));
    EXPECT_NEAR(sum.integration, 0, close_to(1e-9, 1e-4));
    EXPECT_EQ(sum.gravity, 0);
}

TEST_P(Ledger, damping_takes_its_share)
{
    sim.gravity(0, 0, 0);
    const dBodyID ball = sim.sphere({0, 0, 0}, 0.2, 2);
    dBodySetLinearDamping(ball, real(0.1)), dBodySetAngularDamping(ball, real(0.2));
    velocity(ball, {3, 0, 0}, {0, 0, 5});
    const double moving = 0.5 * 2 * 9, turning = kinetic_energy(ball) - moving;
    const Total sum = run(1);
    EXPECT_NEAR(sum.damping, -moving * (1 - 0.81) - turning * (1 - 0.64), close_to(1e-9, 1e-4));
    EXPECT_NEAR(sum.kinetic, sum.damping, close_to(1e-9, 1e-4));
}

// e^2 of the energy of the impact is left.
TEST_P(Ledger, an_impact_takes_what_restitution_does_not_give_back)
{
    h = 0.001;
    const double m = 2, e = 0.5;
    dWorldSetCFM(sim.world, 0);  // that of floats takes a part of the rebound
    const dGeomID floor = sim.ground();
    sim.surface.mode = dContactBounce, sim.surface.bounce = real(e), sim.surface.bounce_vel = real(0.1);
    const dBodyID ball = sim.sphere({0, 0, 1.1}, 0.1, m);
    set_material(floor, 0, e), set_material(geom_of(ball), 0, e);
    Total sum;
    double speed = 0;
    for (int i = 0; i < 600 && !(velocity(ball).z > 0); ++i) {
        speed = velocity(ball).z;
        step(sim, GetParam(), h);
        add(ledger_of(sim), sum);
    }
    ASSERT_GT(velocity(ball).z, 1);
    const double lost = -0.5 * m * speed * speed * (1 - e * e);
    EXPECT_NEAR(sum.impacts, lost, 0.02 * std::fabs(lost));
    EXPECT_NEAR(sum.gravity, m * kG * (1.1 - position(ball).z), close_to(1e-9, 1e-3));
    EXPECT_NEAR(sum.correction, 0, 0.01 * std::fabs(lost));
    EXPECT_NEAR(sum.integration, 0, 0.01 * std::fabs(lost));
}

TEST_P(Ledger, friction_takes_the_energy_of_what_slides)
{
    h = 0.002;
    const double m = 4, mu = 0.3, v = 2;
    const dGeomID floor = sim.ground();
    sim.surface.mu = real(mu), sim.surface.mode = dContactApprox1;
    const dBodyID box = sim.box({0, 0, 0.2}, {1, 1, 0.4}, m);
    set_material(floor, mu), set_material(geom_of(box), mu);
    run(100);
    velocity(box, {v, 0, 0});
    const double start = position(box).x;
    const Total sum = run(600);
    ASSERT_NEAR(velocity(box).x, 0, 1e-3);
    const double way = position(box).x - start;
    EXPECT_NEAR(way, v * v / (2 * mu * kG), 0.02 * way);
    EXPECT_NEAR(sum.friction, -mu * m * kG * way, 0.02 * mu * m * kG * way);
    EXPECT_NEAR(sum.friction, -0.5 * m * v * v, 0.005 * 0.5 * m * v * v);
    EXPECT_NEAR(sum.correction, 0, 0.01);
    EXPECT_NEAR(sum.impacts, 0, 0.02);
    EXPECT_NEAR(sum.joints, 0, 1e-9);
}

TEST_P(Ledger, a_belt_drives_and_rubs)
{
    if (!GetParam().world_contacts) GTEST_SKIP() << "belts are materials";
    h = 0.002;
    const double m = 4, mu = 0.3, v = 1.5;
    const dGeomID floor = sim.ground();
    const dBodyID box = sim.box({0, 0, 0.2}, {1, 1, 0.4}, m);
    set_material(floor, mu, 0, {v, 0, 0}), set_material(geom_of(box), mu);
    const Total sum = run(600);
    const double carried = std::fabs(velocity(box).x);
    ASSERT_NEAR(carried, v, 1e-3);
    // Half of what the belt puts in is rubbed away.
    EXPECT_NEAR(sum.drives, m * v * v, 0.01 * m * v * v);
    EXPECT_NEAR(sum.friction, -0.5 * m * v * v, 0.01 * m * v * v);
}

TEST_P(Ledger, a_motor_works_by_torque_and_angle)
{
    sim.gravity(0, 0, 0);
    const dBodyID wheel = sim.body({0, 0, 0}, 1, 0.5);
    const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, wheel, nullptr);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dJointSetHingeParam(hinge, dParamVel, 4), dJointSetHingeParam(hinge, dParamFMax, real(0.6));
    Total sum = run(100);  // 1.2 rad/s^2
    EXPECT_NEAR(sum.drives, 0.5 * 0.5 * 1.2 * 1.2, close_to(1e-6, 1e-3));
    EXPECT_NEAR(sum.drives, 0.6 * std::fabs(double(dJointGetHingeAngle(hinge))), 0.02 * sum.drives);
    sum = run(400);
    EXPECT_NEAR(std::fabs(spin(wheel).z), 4, 1e-3);
    EXPECT_NEAR(sum.drives, 0.25 * (16 - 1.44), close_to(1e-3, 1e-2));
    EXPECT_NEAR(sum.joints + sum.integration, 0, close_to(1e-6, 1e-3));
}

TEST_P(Ledger, a_spring_gives_what_it_holds)
{
    h = 0.001;
    sim.gravity(0, 0, 0);
    const double k = 200, m = 2, x = 0.1;
    const dBodyID body = sim.body({x, 0, 0}, m);
    const dJointID slider = dJointCreateSlider(sim.world, nullptr);
    dJointAttach(slider, body, nullptr);
    dJointSetSliderAxis(slider, 1, 0, 0);
    dDrive drive;
    dDriveInit(&drive, sizeof drive);
    drive.stiffness = real(k);
    drive.target = real(dJointGetSliderPosition(slider) - x);
    ASSERT_EQ(dJointSetDrive(slider, 0, &drive), 1);
    const int quarter = int(std::acos(-1.0) / 2 / std::sqrt(k / m) / h);
    const Total sum = run(quarter);
    EXPECT_NEAR(position(body).x, 0, 0.01 * x);
    EXPECT_NEAR(sum.drives, 0.5 * k * x * x, 0.05 * 0.5 * k * x * x);
    EXPECT_NEAR(sum.integration + sum.joints, 0, 0.01 * sum.drives);
}

// Rigid joints do no work, and what integration adds or takes vanishes with the step.
TEST_P(Ledger, of_a_pendulum_converges_to_gravity_alone)
{
    double before = 0;
    for (int halved = 0; halved < 3; ++halved) {
        Sim rig;
        set_up(rig, GetParam());
        const double step_length = 0.01 / (1 << halved);
        const dBodyID bob = rig.sphere({1, 0, 0}, 0.1, 2), second = rig.sphere({2, 0, 0}, 0.1, 1);
        for (const dBodyID body : {bob, second}) {
            const dJointID joint = dJointCreateBall(rig.world, nullptr);
            dJointAttach(joint, body, body == bob ? nullptr : bob);
            dJointSetBallAnchor(joint, body == bob ? 0 : 1, 0, 0);
        }
        Total sum;
        double error = 0;
        for (int i = 0; i < 40 << halved; ++i) {
            step(rig, GetParam(), step_length);
            const dEnergyLedger l = ledger_of(rig);
            add(l, sum);
            error += std::fabs(l.integration) + std::fabs(l.joints) + std::fabs(l.correction);
        }
        EXPECT_EQ(sum.drives + sum.friction + sum.impacts + sum.damping, 0);
        if (halved > 0) { EXPECT_LT(error, 0.65 * before); }
        EXPECT_LT(error, 0.2 * sum.gravity);
        before = error;
    }
}

TEST_P(Ledger, of_a_stack_at_rest_is_empty)
{
    sim.ground();
    for (int i = 0; i < 5; ++i) sim.box({0, 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 2);
    run(300);
    const Total sum = run(100);
    const double kick = 100 * 10 * kG * kG * h * h;  // what would move if gravity's kicks counted
    const double bound = (GetParam().way == Way::kQuick ? 0.05 : 0.02) * kick;  // its stacks tremble
    for (const double share : {sum.gravity, sum.friction, sum.impacts, sum.correction, sum.integration})
        EXPECT_LT(std::fabs(share), bound);
    EXPECT_EQ(sum.drives + sum.joints + sum.damping + sum.forces, 0);
}

// A blow at an angle turns the slip that friction opposes: what it does against friction is its own. Bodies that fall
// turned and spinning, under presets and in steps of any length.
TEST_P(Ledger, friction_takes_and_never_gives)
{
    Random random(11);
    for (const dDefaults preset : {dDefaultsOde, dDefaultsGame, dDefaultsRobot})
        for (const double step_length : {1.0 / 30, 1.0 / 120, 1.0 / 1000})
            for (int k = 0; k < 3; ++k) {
                Sim rig;
                ASSERT_EQ(dWorldUseDefaults(rig.world, preset), 1);
                set_up(rig, GetParam());
                rig.surface.mu = k == 2 ? dInfinity : real(0.5), rig.surface.mode = dContactApprox1;
                const dGeomID floor = rig.ground();
                const dBodyID body = k == 0   ? rig.box({0, 0, 1}, {0.3, 0.2, 0.4}, 1)
                                     : k == 1 ? rig.capsule({0, 0, 1}, 0.1, 0.6, 1)
                                              : rig.box({0, 0, 1}, {1, 0.2, 0.2}, 1);
                set_material(floor, double(rig.surface.mu)),
                    set_material(geom_of(body), double(rig.surface.mu));
                dQuaternion q;
                random.quaternion(q);
                dBodySetQuaternion(body, q);
                velocity(body, random.point(2), random.point(5));
                double falling = 0;
                Total sum;
                for (double t = 0; t < 1.2; t += step_length) {
                    step(rig, GetParam(), step_length);
                    const dEnergyLedger l = ledger_of(rig);
                    add(l, sum);
                    falling = std::max(falling, l.kinetic_before);
                    EXPECT_LE(l.friction, 0) << k << " " << step_length << " at " << t;
                }
                EXPECT_GT(falling, 5);
                EXPECT_LT(sum.friction, -0.001 * falling);
                EXPECT_LT(sum.friction + sum.impacts, -0.5 * falling) << "the floor has most of it";
            }
}

// What blow-ups show first: depth becomes energy.
TEST_P(Ledger, pushing_bodies_apart_is_correction)
{
    const dGeomID floor = sim.ground();
    const dBodyID box = sim.box({0, 0, 0.1}, {0.5, 0.5, 0.5}, 2);  // 0.15 m deep
    set_material(floor, 0.5), set_material(geom_of(box), 0.5);
    const Total sum = run(100);
    const double lifted = 2 * kG * (position(box).z - 0.1);
    ASSERT_GT(lifted, 1.5);
    EXPECT_GT(sum.correction, 0.9 * lifted);
    EXPECT_NEAR(sum.correction + sum.impacts + sum.friction + sum.integration, lifted, 0.05 * lifted);
    EXPECT_LT(std::fabs(sum.integration), 0.35 * lifted);
}

TEST_P(Ledger, kinematic_bodies_drive)
{
    const double m = 2, v = 0.5;
    const dBodyID lift = sim.box({0, 0, -0.1}, {2, 2, 0.2}, 1);
    dBodySetKinematic(lift);
    const dBodyID box = sim.box({0, 0, 0.25}, {0.5, 0.5, 0.5}, m);
    run(50);
    velocity(lift, {0, 0, v});
    const Total sum = run(100);
    ASSERT_NEAR(position(box).z, 0.25 + v, 0.02);
    const double gained = m * kG * v + 0.5 * m * v * v;
    // The blow at the start: half of it is lost.
    EXPECT_NEAR(sum.drives, gained + 0.5 * m * v * v, 0.03 * gained);
    EXPECT_NEAR(sum.impacts, -0.5 * m * v * v, 0.03 * gained);
}

TEST_P(Ledger, closes_in_any_scene_and_changes_no_bit_of_it)
{
    for (const Scene scene : kScenes) {
        Sim with, without;
        set_up(with, GetParam()), set_up(without, GetParam());
        build(with, scene), build(without, scene);
        dWorldSetEnergyLedgerMode(without.world, 0);
        with.surface.mu = without.surface.mu = real(0.6);
        Total sum;
        for (int i = 0; i < 60; ++i) {
            step(with, GetParam(), 0.01), step(without, GetParam(), 0.01);
            const dEnergyLedger all = ledger_of(with);
            add(all, sum);
            double kinetic = 0, integration = 0, energy_now = 0;
            for (int k = 0; k < all.islands; ++k) {
                dEnergyLedger one{};
                one.struct_size = sizeof one;
                ASSERT_EQ(dWorldGetIslandEnergyLedger(with.world, k, &one), 1);
                EXPECT_EQ(one.islands, 1);
                EXPECT_NE(one.body, nullptr);
                kinetic += one.kinetic_after, integration += one.integration;
            }
            for (const dBodyID b : with.bodies)
                if (!dBodyIsKinematic(b)) energy_now += kinetic_energy(b);
            EXPECT_NEAR(kinetic, all.kinetic_after, 1e-9 * (1 + kinetic));
            EXPECT_NEAR(integration, all.integration, 1e-9 * (1 + kinetic));
            EXPECT_NEAR(energy_now, all.kinetic_after, close_to(1e-9, 1e-4) * (1 + kinetic));
        }
        EXPECT_GT(sum.moved, 1);
        EXPECT_EQ(hash_state(with), hash_state(without)) << int(scene);
    }
}

TEST(EnergyLedger, answers_only_when_it_is_kept)
{
    Sim sim;
    sim.sphere({0, 0, 3}, 0.1, 1);
    dEnergyLedger l{};
    l.struct_size = sizeof l;
    EXPECT_EQ(dWorldGetEnergyLedgerMode(sim.world), 0);
    sim.steps(1, 0.01);
    EXPECT_EQ(dWorldGetEnergyLedger(sim.world, &l), 0);
    ASSERT_EQ(dWorldSetEnergyLedgerMode(sim.world, 1), 1);
    EXPECT_EQ(dWorldGetEnergyLedgerMode(sim.world), 1);
    EXPECT_EQ(dWorldGetEnergyLedger(sim.world, &l), 0) << "before a step";
    sim.steps(1, 0.01);
    EXPECT_EQ(dWorldGetEnergyLedger(sim.world, &l), 1);
    EXPECT_EQ(l.islands, 1);
    const Messages messages;
    EXPECT_EQ(dWorldGetIslandEnergyLedger(sim.world, 1, &l), 0);
    EXPECT_EQ(dWorldSetEnergyLedgerMode(sim.world, 2), 0);
    l.struct_size = 3;
    EXPECT_EQ(dWorldGetEnergyLedger(sim.world, &l), 0);
    EXPECT_EQ(messages.count(), 3);
    dWorldSetEnergyLedgerMode(sim.world, 0);
    l.struct_size = sizeof l;
    EXPECT_EQ(dWorldGetEnergyLedger(sim.world, &l), 0);
}

// A stopped body keeps its velocity: the fall that it is spared is a correction.
TEST(EnergyLedger, knows_bodies_that_continuous_collision_stops)
{
    Sim sim;
    sim.gravity(0, 0, -kG);
    dWorldSetEnergyLedgerMode(sim.world, 1);
    sim.ground();
    const dBodyID ball = sim.sphere({0, 0, 2}, 0.1, 1);
    dGeomSetContinuous(geom_of(ball), dContinuousOn);
    velocity(ball, {0, 0, -500});
    ASSERT_EQ(dWorldQuickStep(sim.world, real(0.01)), 1);
    ASSERT_GT(position(ball).z, 0);
    dEnergyLedger l{};
    l.struct_size = sizeof l;
    ASSERT_EQ(dWorldGetEnergyLedger(sim.world, &l), 1);
    EXPECT_NEAR(l.gravity, kG * (2 - position(ball).z), close_to(1e-9, 1e-3));
    EXPECT_NEAR(l.kinetic_after - l.kinetic_before, shares_of(l), 1e-12 * l.kinetic_after);
    EXPECT_NEAR(l.correction, kG * (500 * 0.01 - (2 - position(ball).z)), 0.1);
}

}  // namespace
}  // namespace epode::physics
