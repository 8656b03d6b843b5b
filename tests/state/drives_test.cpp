// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Drives, counted turns, springs in physical units and joints that have broken belong to a world's state. An
// arm of three links: a servo with a rotor, an axis that turns on and on, a stop held by a spring, and a ball
// joint that a blow breaks between the two saves.
#include "scene.h"

namespace epode::states {
namespace {

constexpr dReal kStep = dReal(1.0 / 120);

class Arm {
  public:
    explicit Arm(bool drives = true)
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        for (int i = 0; i < 3; ++i) {
            links[i] = dBodyCreate(world);
            dBodySetPosition(links[i], dReal(i + 0.5), 0, 0);
            hinges[i] = dJointCreateHinge(world, nullptr);
            dJointAttach(hinges[i], links[i], i > 0 ? links[i - 1] : nullptr);
            dJointSetHingeAnchor(hinges[i], dReal(i), 0, 0);
            dJointSetHingeAxis(hinges[i], 0, 1, 0);
        }
        load = dBodyCreate(world);
        dBodySetPosition(load, 3, 0, -1);
        ball = dJointCreateBall(world, nullptr);
        dJointAttach(ball, load, links[2]);
        dJointSetBallAnchor(ball, 3, 0, 0);
        if (drives) add_drives();
    }
    ~Arm() { dWorldDestroy(world); }
    Arm(const Arm&) = delete;
    Arm& operator=(const Arm&) = delete;

    void steps(int count, Stepper stepper)
    {
        for (int i = 0; i < count; ++i, ++done) {
            if (done == 60) dBodyAddForce(load, 0, 0, -50000);  // the blow
            if (stepper == Stepper::kExact) dWorldStep(world, kStep);
            if (stepper == Stepper::kQuick) dWorldQuickStep(world, kStep);
            if (stepper == Stepper::kSubsteps) dWorldStepFast1(world, kStep, 4);
            if (stepper == Stepper::kHybrid) dWorldStepHybrid(world, kStep);
        }
    }

    Bytes save() const
    {
        Bytes bytes(dWorldGetStateSize(world));
        EXPECT_EQ(dWorldGetState(world, bytes.data(), bytes.size()), 1);
        return bytes;
    }
    bool restore(const Bytes& bytes) { return dWorldSetState(world, bytes.data(), bytes.size()) == 1; }

    dWorldID world = dWorldCreate();
    dBodyID links[3], load;
    dJointID hinges[3], ball;
    int done = 0;

  private:
    void add_drives()
    {
        dDrive servo;
        dDriveInit(&servo, sizeof servo);
        servo.stiffness = 400, servo.damping = 30, servo.armature = 2, servo.friction = 1;
        servo.target = dReal(-0.3), servo.force_limit = 300;
        EXPECT_EQ(dJointSetDrive(hinges[0], 0, &servo), 1);
        dDrive wheel;
        dDriveInit(&wheel, sizeof wheel);
        wheel.damping = 50, wheel.target_velocity = 9;
        EXPECT_EQ(dJointSetDrive(hinges[1], 0, &wheel), 1);
        EXPECT_EQ(dJointSetAxisContinuous(hinges[1], 0, 1), 1);
        dJointSetHingeParam(hinges[2], dParamLoStop, dReal(-0.2));
        dJointSetHingeParam(hinges[2], dParamHiStop, dReal(0.2));
        EXPECT_EQ(dJointSetStopSpring(hinges[2], 0, 2000, 20), 1);
        EXPECT_EQ(dJointSetBreakLimits(ball, 5000, dInfinity), 1);
    }
};

class DriveStates : public testing::TestWithParam<Stepper> {};

TEST_P(DriveStates, go_on_with_the_same_bits)
{
    Arm arm;
    arm.steps(50, GetParam());
    const Bytes middle = arm.save();
    arm.steps(250, GetParam());
    ASSERT_EQ(dJointIsBroken(arm.ball), 1);
    const dReal turns = dJointGetAxisPosition(arm.hinges[1], 0),
                force = dJointGetDriveForce(arm.hinges[0], 0);
    ASSERT_GT(turns, dReal(6.3)) << "more than one turn";
    const Bytes end = arm.save();

    ASSERT_TRUE(arm.restore(middle));
    EXPECT_EQ(dJointIsBroken(arm.ball), 0);
    EXPECT_EQ(difference(arm.save(), middle), "");
    arm.done = 50;
    arm.steps(250, GetParam());
    EXPECT_EQ(difference(arm.save(), end), "");
    EXPECT_EQ(dJointGetAxisPosition(arm.hinges[1], 0), turns);
    EXPECT_EQ(dJointGetDriveForce(arm.hinges[0], 0), force);
    EXPECT_EQ(dJointIsBroken(arm.ball), 1);
}

// Settings that the program has changed since come back, too.
TEST_P(DriveStates, bring_settings_back)
{
    Arm arm;
    arm.steps(50, GetParam());
    const Bytes middle = arm.save();
    dDrive other;
    dDriveInit(&other, sizeof other);
    other.stiffness = 1;
    ASSERT_EQ(dJointSetDrive(arm.hinges[0], 0, &other), 1);
    ASSERT_EQ(dJointSetStopSpring(arm.hinges[2], 0, 0, 0), 1);
    ASSERT_EQ(dJointSetAxisContinuous(arm.hinges[1], 0, 0), 1);
    ASSERT_TRUE(arm.restore(middle));
    EXPECT_EQ(difference(arm.save(), middle), "");
    ASSERT_EQ(dJointGetDrive(arm.hinges[0], 0, &other), 1);
    EXPECT_EQ(other.stiffness, 400);
    EXPECT_EQ(dJointGetAxisContinuous(arm.hinges[1], 0), 1);
}

// An arm that a step has carried beyond half a turn is still beyond the stop that it has passed, also in a clone.
TEST_P(DriveStates, know_which_stop_has_been_passed)
{
    Arm arm(false);
    const dJointID hinge = arm.hinges[0];
    dWorldSetGravity(arm.world, 0, 0, 0);
    dJointSetHingeParam(hinge, dParamLoStop, dReal(-3.1)),
        dJointSetHingeParam(hinge, dParamHiStop, dReal(3.1));
    dJointSetHingeParam(hinge, dParamVel, 24), dJointSetHingeParam(hinge, dParamFMax, dInfinity);
    for (int i = 0; i < 50 && dJointGetAxisPosition(hinge, 0) < dReal(3.15); ++i) arm.steps(1, GetParam());
    ASSERT_GT(dJointGetAxisPosition(hinge, 0), dReal(3.15));
    ASSERT_LT(dJointGetHingeAngle(hinge), 0);
    const Bytes middle = arm.save();
    dWorldID clone = dWorldClone(arm.world, nullptr, nullptr, 0);
    ASSERT_TRUE(clone);
    arm.steps(20, GetParam());
    const Bytes end = arm.save();
    ASSERT_TRUE(arm.restore(middle));
    arm.steps(20, GetParam());
    EXPECT_EQ(difference(arm.save(), end), "");
    EXPECT_GT(dJointGetAxisPosition(hinge, 0), 3);
    std::swap(arm.world, clone);
    arm.steps(20, GetParam());
    EXPECT_EQ(difference(arm.save(), end), "");
    dWorldDestroy(clone);
}

INSTANTIATE_TEST_SUITE_P(Steppers, DriveStates, testing::ValuesIn(kSteppers),
                         [](const auto& each) { return name_of(each.param); });

// The load of the blow does not outlive the step, although the next one has nothing that moves.
TEST(DriveLoads, of_a_step_taken_back_break_nothing)
{
    Arm arm;
    arm.steps(60, Stepper::kExact);
    const Bytes before = arm.save();
    arm.steps(1, Stepper::kExact);
    ASSERT_FALSE(dJointIsEnabled(arm.ball));
    ASSERT_TRUE(arm.restore(before));
    for (const dBodyID body : {arm.links[0], arm.links[1], arm.links[2], arm.load}) dBodyDisable(body);
    arm.steps(1, Stepper::kExact);
    EXPECT_TRUE(dJointIsEnabled(arm.ball));
}

TEST(DriveStructure, of_a_world_without_drives_are_another_structure)
{
    const Messages messages;
    Arm plain(false), driven;
    EXPECT_FALSE(plain.restore(driven.save()));
    EXPECT_FALSE(driven.restore(plain.save()));
}

}  // namespace
}  // namespace epode::states
