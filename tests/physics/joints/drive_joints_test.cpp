// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Drives on every axis of every joint type that has one, in every way to step; driven arms; what a drive must
// survive: swapped bodies, disabled and destroyed joints, calls at the wrong time, bad numbers.
#include <functional>

#include "drive_ways.h"
#include "golden/golden.h"

namespace epode::physics {
namespace {

struct Joint {
    const char* name;
    std::function<dJointID(Sim&, dBodyID, dBodyID)> make;
};

dJointID attached(dJointID joint, dBodyID a, dBodyID b)
{
    dJointAttach(joint, a, b);
    return joint;
}

// All with their anchors aside from the bodies' centres. `a` or `b` may be the world.
const Joint kJoints[] = {
    {"hinge",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID j = attached(dJointCreateHinge(sim.world, nullptr), a, b);
         dJointSetHingeAnchor(j, real(0.3), real(0.2), 0);
         dJointSetHingeAxis(j, 0, 0, 1);
         return j;
     }},
    {"slider",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID j = attached(dJointCreateSlider(sim.world, nullptr), a, b);
         dJointSetSliderAxis(j, 0, real(0.6), real(0.8));
         return j;
     }},
    {"universal",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID j = attached(dJointCreateUniversal(sim.world, nullptr), a, b);
         dJointSetUniversalAnchor(j, real(0.3), real(0.2), 0);
         dJointSetUniversalAxis1(j, 1, 0, 0);
         dJointSetUniversalAxis2(j, 0, 1, 0);
         return j;
     }},
    {"piston",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID j = attached(dJointCreatePiston(sim.world, nullptr), a, b);
         dJointSetPistonAnchor(j, real(0.3), real(0.2), 0);
         dJointSetPistonAxis(j, 1, 0, 0);
         return j;
     }},
    {"pr",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID j = attached(dJointCreatePR(sim.world, nullptr), a, b);
         dJointSetPRAnchor(j, real(0.3), real(0.2), 0);
         dJointSetPRAxis1(j, 1, 0, 0);
         dJointSetPRAxis2(j, 0, 0, 1);
         return j;
     }},
    {"pu",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID j = attached(dJointCreatePU(sim.world, nullptr), a, b);
         dJointSetPUAnchor(j, real(0.3), real(0.2), 0);
         dJointSetPUAxis1(j, 0, 1, 0);
         dJointSetPUAxis2(j, 0, 0, 1);
         dJointSetPUAxis3(j, 1, 0, 0);
         return j;
     }},
    {"ball and motor",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID ball = attached(dJointCreateBall(sim.world, nullptr), a, b);
         dJointSetBallAnchor(ball, real(0.3), real(0.2), 0);
         dJointID j = attached(dJointCreateAMotor(sim.world, nullptr), a, b);
         dJointSetAMotorMode(j, dAMotorEuler);
         dJointSetAMotorAxis(j, 0, 1, 1, 0, 0);
         dJointSetAMotorAxis(j, 2, 2, 0, 0, 1);
         return j;
     }},
    {"linear motor",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID j = attached(dJointCreateLMotor(sim.world, nullptr), a, b);
         dJointSetLMotorNumAxes(j, 3);
         dJointSetLMotorAxis(j, 0, 0, 1, 0, 0);
         dJointSetLMotorAxis(j, 1, 0, 0, 1, 0);
         dJointSetLMotorAxis(j, 2, 0, 0, 0, 1);
         return j;
     }},
    {"hinge-2",
     [](Sim& sim, dBodyID a, dBodyID b) {
         dJointID j = dJointCreateHinge2(sim.world, nullptr);
         if (!a || !b) return j;
         attached(j, a, b);
         const dReal steer[4] = {0, 0, 1, 0}, spin[4] = {0, 1, 0, 0};
         dJointSetHinge2Anchor(j, 0, 0, 0);
         dJointSetHinge2Axes(j, steer, spin);
         return j;
     }},
};

struct DrivenJoints : testing::TestWithParam<Way> {};

// A servo on each axis of the joint at once, all different.
void reaches_its_targets(Way way, const Joint& type, bool first, bool second)
{
    Sim sim;
    dBodyID link = sim.body({0, 0, 0}, 1, 0.1), base = nullptr;
    if (first && second) {
        base = sim.body({-1, 0, 0}, 1, 0.5);
        dJointID fixed = dJointCreateFixed(sim.world, nullptr);
        dJointAttach(fixed, base, nullptr);
        dJointSetFixed(fixed);
    }
    dJointID j = first ? type.make(sim, link, base) : type.make(sim, nullptr, link);
    const int axes = dJointGetBody(j, 0) || dJointGetBody(j, 1) ? dJointGetNumAxes(j) : 0;
    dDrive drive = no_drive();
    drive.stiffness = 300, drive.damping = 40, drive.armature = real(0.2), drive.force_limit = 200;
    for (int i = 0; i < axes; ++i) {
        drive.target = real(0.2 + 0.1 * i);
        ASSERT_EQ(dJointSetDrive(j, i, &drive), 1) << type.name;
    }
    step(sim, way, 0.01, 600);
    for (int i = 0; i < axes; ++i) {
        EXPECT_NEAR(double(dJointGetAxisPosition(j, i)), 0.2 + 0.1 * i, 1e-3)
            << type.name << " axis " << i << (first ? second ? " (A, B)" : " (A, 0)" : " (0, A)");
        EXPECT_NEAR(double(dJointGetAxisRate(j, i)), 0, 1e-3) << type.name << " axis " << i;
    }
}

TEST_P(DrivenJoints, every_axis_reaches_its_target)
{
    for (const Joint& type : kJoints) {
        reaches_its_targets(GetParam(), type, true, true);
        reaches_its_targets(GetParam(), type, true, false);
        reaches_its_targets(GetParam(), type, false, true);
    }
}

// The same pair named the other way round moves alike when the target has the other sign.
TEST_P(DrivenJoints, bodies_may_be_swapped)
{
    V3 end[2];
    for (int k = 0; k < 2; ++k) {
        Sim sim;
        dBodyID a = sim.body({0, 0, 0}, 1, 0.2), b = sim.body({1, 0, 0}, 2, 0.4);
        dJointID j = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(j, k ? b : a, k ? a : b);
        dJointSetHingeAnchor(j, real(0.4), 0, 0);
        dJointSetHingeAxis(j, 0, 0, 1);
        dDrive drive = no_drive();
        drive.stiffness = 20, drive.damping = 1, drive.target = real(k ? -0.6 : 0.6);
        drive.armature = real(0.1), drive.friction = real(0.05);
        dJointSetDrive(j, 0, &drive);
        step(sim, GetParam(), 0.01, 100);
        end[k] = position(a);
    }
    const bool exact = GetParam() != Way::kQuick && GetParam() != Way::kSubsteps;
    EXPECT_NEAR(length(end[0] - end[1]), 0, exact ? tol(1e-8, 1e-3) : tol(1e-4, 1e-3));
}

// Three links on hinges, hung out sideways, each held by a servo with a rotor much heavier than the link.
struct Arm {
    Sim sim;
    std::vector<dJointID> joints;
    std::vector<dBodyID> links;

    explicit Arm(double inertia = 0.02)
    {
        sim.gravity(0, 0, -9.81);
        dBodyID before = nullptr;
        for (int i = 0; i < 3; ++i) {
            dBodyID link = sim.body({0.25 + 0.5 * i, 0, 0}, 0.5, inertia);
            dJointID j = dJointCreateHinge(sim.world, nullptr);
            dJointAttach(j, link, before);
            dJointSetHingeAnchor(j, real(0.5 * i), 0, 0);
            dJointSetHingeAxis(j, 0, 1, 0);
            joints.push_back(j), links.push_back(link);
            before = link;
        }
    }
    void drive(double stiffness, double damping, double armature, double friction = 0)
    {
        dDrive drive = no_drive();
        drive.stiffness = real(stiffness), drive.damping = real(damping), drive.armature = real(armature);
        drive.friction = real(friction), drive.target = real(-0.4);
        for (dJointID j : joints) ASSERT_EQ(dJointSetDrive(j, 0, &drive), 1);
    }
    // Between where the joint's two bodies think it is.
    double gap() const
    {
        double worst = 0;
        for (dJointID j : joints) {
            dVector3 p, q;
            dJointGetHingeAnchor(j, p), dJointGetHingeAnchor2(j, q);
            worst = std::max(worst, length(vec(p) - vec(q)));
        }
        return worst;
    }
};

TEST_P(DrivenJoints, an_arm_moves_as_with_fine_steps)
{
    Arm fine;
    fine.drive(60, 6, 0.5);
    step(fine.sim, Way::kExact, 0.0002, 2500);
    Arm arm;
    arm.drive(60, 6, 0.5);
    double gap = 0;
    for (int i = 0; i < 100; ++i) step(arm.sim, GetParam(), 0.005), gap = std::max(gap, arm.gap());
    // One sweep a substep over rotors 25 times as heavy as the links is not yet settled.
    const double close = GetParam() == Way::kSubsteps ? 0.1 : 0.02;
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(double(dJointGetAxisPosition(arm.joints[i], 0)),
                    double(dJointGetAxisPosition(fine.joints[i], 0)), close)
            << "joint " << i;
    EXPECT_LT(gap, 1e-3);
}

// Rotors of 1 kg m^2 on links of 0.001, and forces that jump: joints stay closed.
TEST_P(DrivenJoints, light_links_with_heavy_rotors_stay_together)
{
    Arm arm(0.001);
    Random random(5);
    double gap = 0;
    for (int i = 0; i < 300; ++i) {
        for (dJointID j : arm.joints) {
            dDrive drive = no_drive();
            drive.armature = 1, drive.damping = 1, drive.force = real(random.uniform(-20, 20));
            dJointSetDrive(j, 0, &drive);
        }
        step(arm.sim, GetParam(), 0.005);
        gap = std::max(gap, arm.gap());
    }
    ASSERT_TRUE(finite_state(arm.sim));
    EXPECT_LT(gap, GetParam() == Way::kQuick ? 2e-2 : 5e-3);
}

TEST_P(DrivenJoints, have_the_same_bits_on_any_number_of_threads)
{
    std::uint64_t alone = 0;
    for (const int threads : {1, 2, 5}) {
        Arm arm;
        dWorldSetStepThreads(arm.sim.world, threads);
        arm.drive(60, 6, 0.5, 0.3);
        for (int i = 0; i < 7; ++i) {  // islands of their own
            dBodyID b = arm.sim.body({0, 5.0 + i, 0}, 1, 0.1);
            dJointID j = kJoints[i].make(arm.sim, b, nullptr);
            dDrive drive = no_drive();
            drive.stiffness = 30, drive.target = 1, drive.force_limit = 5, drive.friction = real(0.2);
            for (int k = 0; k < dJointGetNumAxes(j); ++k) dJointSetDrive(j, k, &drive);
        }
        step(arm.sim, GetParam(), 0.01, 50);
        const std::uint64_t hash = hash_state(arm.sim);
        if (threads == 1) alone = hash;
        EXPECT_EQ(hash, alone) << threads;
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, DrivenJoints, testing::ValuesIn(kWays), way_name);

// On every compiler, and with the kernels of every machine.
TEST(DriveBits, are_the_golden_ones)
{
    if (kSingle) GTEST_SKIP() << "the table is that of double precision";
    constexpr Way kGoldenWays[] = {Way::kExact, Way::kQuick, Way::kSubsteps, Way::kJointsExact};
    for (const Way way : kGoldenWays) {
        Arm arm;
        arm.drive(60, 6, 0.5, 0.3);
        step(arm.sim, way, 0.01, 50);
        EXPECT_TRUE(golden::is_golden(std::string("physics/drives/") + name_of(way), hash_state(arm.sim)));
    }
}

struct DriveCalls : testing::Test {
    Sim sim;
    dBodyID b = sim.body({0, 0, 0}, 2);
    dJointID joint = attached(dJointCreateSlider(sim.world, nullptr), b, nullptr);
    dDrive drive = no_drive();
    DriveCalls()
    {
        dJointSetSliderAxis(joint, 1, 0, 0);
        drive.force = 4;
    }
};

TEST_F(DriveCalls, a_drive_is_read_back_and_taken_away)
{
    dDrive read = no_drive();
    EXPECT_EQ(dJointGetDrive(joint, 0, &read), 0);
    EXPECT_EQ(dJointSetDrive(joint, 0, &drive), 1);
    EXPECT_EQ(dJointGetDrive(joint, 0, &read), 1);
    EXPECT_EQ(read.force, 4);
    dWorldStep(sim.world, real(0.01));
    EXPECT_NEAR(double(dJointGetDriveForce(joint, 0)), 4, 1e-6);
    EXPECT_EQ(dJointSetDrive(joint, 0, nullptr), 1);
    EXPECT_EQ(dJointGetDrive(joint, 0, &read), 0);
    EXPECT_EQ(dJointGetDriveForce(joint, 0), 0);
    const V3 before = velocity(b);
    dWorldStep(sim.world, real(0.01));
    EXPECT_EQ(velocity(b).x, before.x);
}

TEST_F(DriveCalls, a_disabled_joint_does_not_drive)
{
    dJointSetDrive(joint, 0, &drive);
    dJointDisable(joint);
    dWorldStep(sim.world, real(0.01));
    EXPECT_EQ(velocity(b).x, 0);
    dJointEnable(joint);
    dWorldStep(sim.world, real(0.01));
    EXPECT_NEAR(velocity(b).x, 0.02, 1e-6);
    dJointDestroy(joint);
    dWorldStep(sim.world, real(0.01));
    EXPECT_NEAR(velocity(b).x, 0.02, 1e-6);
}

TEST_F(DriveCalls, feedback_holds_the_drive)
{
    dJointFeedback feedback{};
    dJointSetFeedback(joint, &feedback);
    dJointSetDrive(joint, 0, &drive);
    dWorldStep(sim.world, real(0.01));
    EXPECT_NEAR(double(feedback.f1[0]), 4, 1e-5);
}

TEST_F(DriveCalls, a_change_wakes_the_bodies)
{
    dBodyDisable(b);
    EXPECT_EQ(dJointSetDrive(joint, 0, &drive), 1);
    EXPECT_EQ(dBodyIsEnabled(b), 1);
    dBodyDisable(b);
    EXPECT_EQ(dJointSetDrive(joint, 0, &drive), 1) << "nothing has changed";
    EXPECT_EQ(dBodyIsEnabled(b), 0);
}

TEST_F(DriveCalls, bad_arguments_are_refused_with_their_values)
{
    Messages messages;
    dJointSetDrive(joint, 0, &drive);
    drive.stiffness = -3;
    EXPECT_EQ(dJointSetDrive(joint, 0, &drive), 0);
    EXPECT_NE(messages.last().find("stiffness is -3, must be finite and 0 or more"), std::string::npos)
        << messages.last();
    drive = no_drive();
    drive.target = real(std::nan(""));
    EXPECT_EQ(dJointSetDrive(joint, 0, &drive), 0);
    drive = no_drive();
    drive.struct_size = 800;
    EXPECT_EQ(dJointSetDrive(joint, 0, &drive), 0);
    drive = no_drive();
    for (const int axis : {-1, 1, 3}) EXPECT_EQ(dJointSetDrive(joint, axis, &drive), 0);
    EXPECT_EQ(dJointSetDrive(dJointCreateBall(sim.world, nullptr), 0, &drive), 0);
    EXPECT_EQ(dJointGetDrive(joint, 0, &drive), 1);
    EXPECT_EQ(drive.force, 4) << "nothing has changed";
}

dJointID g_joint;
int g_answer;

TEST_F(DriveCalls, a_call_during_a_step_is_refused)
{
    Messages messages;
    g_joint = joint, g_answer = -1;
    dBodySetMovedCallback(b, [](dBodyID) {
        const dDrive none = no_drive();
        g_answer = dJointSetDrive(g_joint, 0, &none);
    });
    dGeomSetBody(dCreateSphere(sim.space, 1), b);
    dJointSetDrive(joint, 0, &drive);
    dWorldStep(sim.world, real(0.01));
    EXPECT_EQ(g_answer, 0);
    EXPECT_EQ(messages.count(), 1);
}

TEST_F(DriveCalls, a_joint_in_a_group_outlives_its_world)
{
    dWorldID world = dWorldCreate();
    dJointGroupID group = dJointGroupCreate(0);
    dJointID j = dJointCreateHinge(world, group);
    EXPECT_EQ(dJointSetDrive(j, 0, &drive), 1);
    dWorldDestroy(world);
    EXPECT_EQ(dJointSetDrive(j, 0, nullptr), 1);
    dJointGroupDestroy(group);
}

// An angle's servo goes the shorter way; one that counts turns goes all the way.
TEST(DriveTurns, a_continuous_axis_follows_a_target_of_several_turns)
{
    for (const int continuous : {0, 1}) {
        Sim sim;
        dBodyID b = sim.body({0, 0, 0}, 1, 1);
        dJointID j = attached(dJointCreateHinge(sim.world, nullptr), b, nullptr);
        dJointSetHingeAxis(j, 0, 0, 1);
        dJointSetAxisContinuous(j, 0, continuous);
        dDrive drive = no_drive();
        drive.stiffness = 100, drive.damping = 20, drive.target = real(6 * kPi + 0.5);
        dJointSetDrive(j, 0, &drive);
        for (int i = 0; i < 800; ++i) dWorldStep(sim.world, real(0.01));
        EXPECT_NEAR(double(dJointGetAxisPosition(j, 0)), continuous ? 6 * kPi + 0.5 : 0.5, 1e-4);
    }
}

}  // namespace
}  // namespace epode::physics
