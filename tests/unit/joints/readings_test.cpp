// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Signs and zeros of anchors, axes, angles, positions and rates, as clients of ODE know them.
#include <gtest/gtest.h>

#include <cmath>

#include "joints/reading.h"
#include "ode/ext.h"
#include "ode/objects.h"
#include "rig.h"

namespace epode::test {
namespace {

constexpr Real kNear = kSingle ? Real(1e-5) : Real(1e-12);
constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

struct Readings : testing::Test {
    Rig rig;
    Body* a = rig.body({0, 0, 0});
    Body* b = rig.body({2, 0, 0});
    dVector3 r = {0, 0, 0, 0};
};

TEST_F(Readings, a_ball_keeps_its_local_anchor_from_attachment_to_attachment)
{
    const dJointID j = dJointCreateBall(rig.id(), nullptr);
    Rig::join(j, a);
    dJointSetBallAnchor(j, 1, 0, 0);
    Body* c = rig.body({5, 0, 0});
    Rig::join(j, c);
    dJointGetBallAnchor(j, r);
    EXPECT_EQ(r[0], 6);
    Rig::join(j, nullptr, a);
    dJointGetBallAnchor(j, r);
    EXPECT_EQ(r[0], 6);
    dJointGetBallAnchor2(j, r);
    EXPECT_EQ(r[0], 6);
}

TEST_F(Readings, an_anchor_set_before_attaching_is_lost)
{
    const dJointID j = dJointCreateBall(rig.id(), nullptr);
    dJointSetBallAnchor(j, 1, 2, 3);
    r[0] = 77;
    dJointGetBallAnchor(j, r);
    EXPECT_EQ(r[0], 77) << "untouched without bodies";
    Rig::join(j, b);
    dJointGetBallAnchor(j, r);
    EXPECT_EQ(r[0], 2) << "the body's position";
}

TEST_F(Readings, hinge_angle_is_the_turn_of_body_1_and_negated_when_reversed)
{
    for (const bool reversed : {false, true}) {
        Rig::place(a, {0, 0, 0});
        const dJointID j = dJointCreateHinge(rig.id(), nullptr);
        reversed ? Rig::join(j, nullptr, a) : Rig::join(j, a);
        dJointSetHingeAxis(j, 0, 0, 2);
        Rig::place(a, {0, 0, 0}, turn(kZ, Real(0.3)));
        Rig::velocity(a, {}, {0, 0, 4});
        const Real sign = reversed ? -1 : 1;
        EXPECT_NEAR(dJointGetHingeAngle(j), sign * Real(0.3), kNear);
        EXPECT_NEAR(dJointGetHingeAngleRate(j), sign * 4, kNear);
        dJointAddHingeTorque(j, 5);
        EXPECT_NEAR(a->tacc[2], sign * 5, kNear);
        a->tacc[2] = 0;
        // Stops keep the internal sign in both cases.
        dJointSetHingeParam(j, dParamHiStop, Real(0.2));
        const Emitted e = rig.emit(j);
        ASSERT_EQ(e.rows.size(), 6u);
        EXPECT_NEAR(e.rows[5].error, -0.1, 10 * kNear);
    }
}

TEST_F(Readings, hinge_angle_wraps_at_half_a_turn)
{
    const dJointID j = dJointCreateHinge(rig.id(), nullptr);
    Rig::join(j, a);
    dJointSetHingeAxis(j, 0, 0, 1);
    for (const Real angle : {Real(-3), Real(-0.1), Real(2), Real(3.1)}) {
        Rig::place(a, {0, 0, 0}, turn(kZ, angle));
        EXPECT_NEAR(dJointGetHingeAngle(j), angle, kNear);
    }
    Rig::place(a, {0, 0, 0}, turn(kZ, 4));
    EXPECT_NEAR(dJointGetHingeAngle(j), 4 - 2 * kPi, kNear);
}

Real turns_off(Real angle, Real expected) { return std::remainder(angle - expected, 2 * kPi); }

// The turn that the hinge has at the call counts twice, so that a body turned by the given angle reads it.
TEST_F(Readings, hinge_offset_reads_twice_the_turn_less_the_given_angle)
{
    for (int way = 0; way < 3; ++way)
        for (const Real turned : {0.0, 0.5, 1.5708, -0.7, -3.0})
            for (const Real given : {0.0, 0.23, -1.5708, 2.9}) {
                SCOPED_TRACE(testing::Message() << way << " " << turned << " " << given);
                Rig::place(a, {0, 0, 0}), Rig::place(b, {2, 0, 0});
                const dJointID j = dJointCreateHinge(rig.id(), nullptr);
                if (way == 0) Rig::join(j, a, b);
                if (way == 1) Rig::join(j, a);
                if (way == 2) Rig::join(j, nullptr, a);
                dJointSetHingeAxis(j, 0, 0, 1);
                Rig::place(a, {0, 0, 0}, turn(kZ, turned));
                dJointSetHingeAxisOffset(j, 0, 0, 4, given);
                const Real as_read = way == 2 ? -turned : turned;  // reversed, the angle runs backwards
                EXPECT_NEAR(turns_off(dJointGetHingeAngle(j), 2 * as_read - given), 0, kNear);
                Rig::place(a, {0, 0, 0}, turn(kZ, turned + Real(0.4)));
                EXPECT_NEAR(turns_off(dJointGetHingeAngle(j), 2 * as_read - given + (way == 2 ? -0.4 : 0.4)),
                            0, kNear);
                dJointSetHingeAxis(j, 0, 0, 1);
                EXPECT_NEAR(dJointGetHingeAngle(j), 0, kNear) << "the offset is gone";
                dJointDestroy(j);
            }
}

// The stop acts on the angle that is read, minus the sign of a reversed joint.
TEST_F(Readings, hinge_offset_moves_the_stops)
{
    for (const bool reversed : {false, true}) {
        Rig::place(a, {0, 0, 0});
        const dJointID j = dJointCreateHinge(rig.id(), nullptr);
        reversed ? Rig::join(j, nullptr, a) : Rig::join(j, a);
        dJointSetHingeAxisOffset(j, 0, 0, 1, Real(-0.5));
        const Real internal = reversed ? Real(-0.5) : Real(0.5);
        dJointSetHingeParam(j, dParamLoStop, internal - Real(0.3));
        dJointSetHingeParam(j, dParamHiStop, internal - Real(0.1));
        const Emitted e = rig.emit(j);
        ASSERT_EQ(e.rows.size(), 6u);
        EXPECT_NEAR(rig.c(e.rows[5]), -2, 1e-4) << "0.1 beyond the upper stop";
        dJointDestroy(j);
    }
}

TEST_F(Readings, slider_position_grows_as_body_1_goes_along_the_axis)
{
    const dJointID j = dJointCreateSlider(rig.id(), nullptr);
    Rig::join(j, a, b);
    dJointSetSliderAxis(j, 0, 3, 0);
    EXPECT_EQ(dJointGetSliderPosition(j), 0);
    Rig::place(a, {0, Real(0.5), 0});
    Rig::velocity(b, {0, 2, 0});
    EXPECT_NEAR(dJointGetSliderPosition(j), 0.5, kNear);
    EXPECT_NEAR(dJointGetSliderPositionRate(j), -2, kNear);
    dJointAddSliderForce(j, 4);
    EXPECT_NEAR(a->facc[1], 4, kNear);
    EXPECT_NEAR(b->facc[1], -4, kNear);
    EXPECT_NEAR(a->tacc[2] + b->tacc[2] - 2 * 4, 0, kNear) << "balances the couple of the forces";
}

TEST_F(Readings, slider_reversed_negates_and_delta_moves_the_zero)
{
    dJointID j = dJointCreateSlider(rig.id(), nullptr);
    Rig::join(j, nullptr, a);
    dJointSetSliderAxis(j, 1, 0, 0);
    Rig::place(a, {Real(0.25), 0, 0});
    EXPECT_EQ(dJointGetSliderPosition(j), Real(-0.25));
    j = dJointCreateSlider(rig.id(), nullptr);
    Rig::join(j, a);
    dJointSetSliderAxisDelta(j, 1, 0, 0, Real(0.5), 0, 0);
    EXPECT_EQ(dJointGetSliderPosition(j), Real(-0.5));
}

TEST_F(Readings, fixed_takes_the_pose_only_on_request)
{
    const dJointID j = dJointCreateFixed(rig.id(), nullptr);
    Rig::join(j, b);
    EXPECT_EQ(rig.emit(j).rows[0].error, -2) << "pulled to the world's origin";
    dJointSetFixed(j);
    EXPECT_EQ(rig.emit(j).rows[0].error, 0);
    dJointSetFixedParam(j, dParamERP, Real(0.75));
    EXPECT_EQ(rig.emit(j).rows[0].erp, Real(0.75));
    EXPECT_EQ(rig.emit(j).rows[3].erp, rig.info.erp) << "angular rows keep the world's";
}

TEST_F(Readings, universal_angles_turn_body_1_and_the_cross)
{
    const dJointID j = dJointCreateUniversal(rig.id(), nullptr);
    Rig::join(j, a, b);
    dJointSetUniversalAxis1(j, 1, 0, 0);
    dJointSetUniversalAxis2(j, 0, 1, 0);
    Rig::place(a, {0, 0, 0}, turn(kX, Real(0.2)));
    EXPECT_NEAR(dJointGetUniversalAngle1(j), 0.2, kNear);
    EXPECT_NEAR(dJointGetUniversalAngle2(j), 0, kNear);
    Rig::place(b, {2, 0, 0}, turn(kY, Real(-0.4)));
    dReal angle1, angle2;
    dJointGetUniversalAngles(j, &angle1, &angle2);
    EXPECT_NEAR(angle1, 0.2, kNear);
    EXPECT_NEAR(angle2, 0.4, kNear);
}

TEST_F(Readings, universal_reversed_exchanges_axes_angles_and_torques)
{
    const dJointID j = dJointCreateUniversal(rig.id(), nullptr);
    Rig::join(j, nullptr, a);
    dJointSetUniversalAxis1(j, 1, 0, 0);
    dJointSetUniversalAxis2(j, 0, 1, 0);
    Rig::place(a, {0, 0, 0}, turn(kY, Real(0.3)));
    EXPECT_NEAR(dJointGetUniversalAngle1(j), 0, kNear);
    EXPECT_NEAR(dJointGetUniversalAngle2(j), -0.3, kNear);
    dJointAddUniversalTorques(j, 1, 2);
    EXPECT_NEAR(a->tacc[0], -1, kNear);
    EXPECT_NEAR(a->tacc[1], -2, kNear);
}

TEST_F(Readings, universal_offsets_read_as_given_in_every_attachment)
{
    for (int way = 0; way < 3; ++way) {
        Rig::place(a, {0, 0, 0}, turn({1, 2, 3}, 1));
        const dJointID j = dJointCreateUniversal(rig.id(), nullptr);
        Rig::join(j, way == 2 ? nullptr : a, way == 1 ? nullptr : b);
        dJointSetUniversalAxis1(j, 1, 0, 0);
        dJointSetUniversalAxis2Offset(j, 0, 1, 0, Real(0.2), Real(0.4));
        EXPECT_NEAR(dJointGetUniversalAngle1(j), 0.2, kNear) << way;
        EXPECT_NEAR(dJointGetUniversalAngle2(j), 0.4, kNear) << way;
    }
}

struct Wheel : Readings {
    dJointID j = dJointCreateHinge2(rig.id(), nullptr);
    void SetUp() override
    {
        Rig::join(j, a, b);
        dJointSetHinge2Anchor(j, 2, 0, 0);
        const dReal steering[4] = {0, 0, 1, 0}, spin[4] = {0, 1, 0, 0};
        dJointSetHinge2Axes(j, steering, spin);
    }
};

TEST_F(Wheel, turns_with_its_own_sign_and_rates_with_the_other)
{
    Rig::place(b, {2, 0, 0}, turn(kY, Real(0.3)));
    Rig::velocity(b, {}, {0, 1, 0});
    EXPECT_NEAR(dJointGetHinge2Angle2(j), 0.3, kNear);
    EXPECT_NEAR(dJointGetHinge2Angle2Rate(j), -1, kNear);
    Rig::place(b, {2, 0, 0}, turn(kZ, Real(-0.2)));
    EXPECT_NEAR(dJointGetHinge2Angle1(j), 0.2, kNear);
}

TEST_F(Wheel, suspension_is_soft_along_the_steering_axis_only)
{
    dJointSetHinge2Param(j, dParamSuspensionERP, Real(0.5));
    dJointSetHinge2Param(j, dParamSuspensionCFM, Real(0.01));
    Rig::place(b, {Real(2.1), 0, Real(0.1)});
    const std::vector<Row> rows = rig.emit(j).rows;
    EXPECT_NEAR(rig.c(rows[0]), 5, 1e-4);
    EXPECT_TRUE(rows[0].soft);
    EXPECT_EQ(rows[0].cfm, Real(0.01));
    EXPECT_EQ(rows[1].cfm, rig.info.cfm);
    EXPECT_NEAR(std::fabs(rig.c(rows[1])) + std::fabs(rig.c(rows[2])), 2, 1e-4);
}

TEST_F(Wheel, refuses_axes_that_leave_it_undefined)
{
    const dReal up[4] = {0, 0, 5, 0}, zero[4] = {0, 0, 0, 0};
    dJointSetHinge2Axes(j, up, up);
    dJointSetHinge2Axes(j, zero, nullptr);
    dJointSetHinge2Axes(j, nullptr, nullptr);
    dJointGetHinge2Axis2(j, r);
    EXPECT_EQ(r[1], 1);
    const dJointID unattached = dJointCreateHinge2(rig.id(), nullptr);
    dJointSetHinge2Axes(unattached, up, nullptr);
    r[1] = 7;
    dJointGetHinge2Axis1(unattached, r);
    EXPECT_EQ(r[1], 7) << "a refused call writes nothing";
    EXPECT_EQ(dJointGetHinge2Angle1(unattached), 0);
}

// dJointSetHinge2Axis1(y), then Axis2(x): on the way both axes are y, for y is the default of the second.
TEST_F(Wheel, takes_its_axes_one_by_one_through_a_parallel_pair)
{
    const dReal up[4] = {0, 0, 1, 0}, side[4] = {1, 0, 0, 0};
    dJointSetHinge2Axes(j, side, up);
    dJointSetHinge2Axes(j, up, nullptr);
    dJointSetHinge2Axes(j, nullptr, side);
    dJointGetHinge2Axis1(j, r);
    EXPECT_EQ(r[2], 1);
    dJointGetHinge2Axis2(j, r);
    EXPECT_EQ(r[0], 1);
    EXPECT_EQ(dJointGetHinge2Angle1(j), 0);
    EXPECT_EQ(dJointGetHinge2Angle2(j), 0);
    dJointSetHinge2Axes(j, up, up);
    dJointGetHinge2Axis2(j, r);
    EXPECT_EQ(r[0], 1) << "both at once must differ";
}

TEST_F(Wheel, keeps_its_numbers_while_both_axes_are_one)
{
    const dReal axis[4] = {0, 0, 1, 0};
    dJointSetHinge2Axes(j, nullptr, axis);
    for (int step = 0; step < 10; ++step) dWorldStep(rig.id(), Real(0.01));
    EXPECT_TRUE(std::isfinite(length(b->position() - a->position())));
}

TEST_F(Wheel, never_tests_stops_on_the_wheel)
{
    dJointSetHinge2Param(j, dParamLoStop2, Real(0.5));
    dJointSetHinge2Param(j, dParamHiStop2, Real(0.6));
    EXPECT_EQ(rig.emit(j).rows.size(), 4u);
    dJointSetHinge2Param(j, dParamFMax2, 3);
    EXPECT_EQ(rig.emit(j).rows.size(), 5u);
    EXPECT_EQ(dJointGetHinge2Param(j, dParamFMax), 0);
}

TEST_F(Readings, euler_motor_separates_the_three_turns)
{
    for (const bool reversed : {false, true}) {
        Rig::place(a, {0, 0, 0});
        const dJointID j = dJointCreateAMotor(rig.id(), nullptr);
        reversed ? Rig::join(j, nullptr, a) : Rig::join(j, a);
        dJointSetAMotorMode(j, dAMotorEuler);
        dJointSetAMotorAxis(j, 0, 1, 1, 0, 0);
        dJointSetAMotorAxis(j, 2, 2, 0, 0, 1);
        EXPECT_EQ(dJointGetAMotorNumAxes(j), 3);
        EXPECT_EQ(dJointGetAMotorAxisRel(j, 0), 1);
        const Vec3 axes[3] = {kX, kY, kZ};
        for (int k = 0; k < 3; ++k) {
            Rig::place(a, {0, 0, 0}, turn(axes[k], Real(0.2)));
            Rig::velocity(a, {}, axes[k]);
            rig.emit(j);
            for (int i = 0; i < 3; ++i) {
                const Real sign = reversed ? -1 : 1;
                EXPECT_NEAR(dJointGetAMotorAngle(j, i), i == k ? sign * Real(0.2) : 0, kNear) << k << i;
                EXPECT_NEAR(dJointGetAMotorAngleRate(j, i), i == k ? sign : 0, 0.3 * (i != k) + kNear);
            }
        }
    }
}

// As ODE has it: numbers given with rel 0 are taken as seen from the body that the axis belongs to; the wrong
// body stays refused.
TEST_F(Readings, euler_axes_may_be_given_with_rel_0)
{
    for (int way = 0; way < 3; ++way) {
        Rig::place(a, {0, 0, 0}), Rig::place(b, {2, 0, 0});
        const dJointID j = dJointCreateAMotor(rig.id(), nullptr);
        if (way == 0) Rig::join(j, a, b);
        if (way == 1) Rig::join(j, a);
        if (way == 2) Rig::join(j, nullptr, a);
        dJointSetAMotorMode(j, dAMotorEuler);
        dJointSetAMotorAxis(j, 0, 0, 1, 0, 0);
        dJointSetAMotorAxis(j, 2, 0, 0, 0, 1);
        const Vec3 axes[3] = {kX, kY, kZ};
        for (int i = 0; i < 3; ++i) {
            dJointGetAMotorAxis(j, i, r);
            EXPECT_NEAR(length(load(r) - axes[i]), 0, kNear) << way << i;
            EXPECT_EQ(dJointGetAMotorAxisRel(j, i), 0);
        }
        dJointSetAMotorAxis(j, 0, 2, 0, 1, 0);
        dJointSetAMotorAxis(j, 2, 1, 0, 1, 0);
        dJointGetAMotorAxis(j, 0, r);
        EXPECT_NEAR(length(load(r) - kX), 0, kNear) << "rel 2 is not axis 0's body";
        Rig::place(a, {0, 0, 0}, turn(kZ, kPi / 2));
        const int own = way == 2 ? 2 : 0;
        dJointSetAMotorAxis(j, own, 0, own ? 0 : 1, 0, own ? 1 : 0);
        dJointGetAMotorAxis(j, 0, r);
        EXPECT_NEAR(length(load(r) - (way == 2 ? kX : kY)), 0, kNear) << "the numbers turn with the body";
    }
}

TEST_F(Readings, euler_stops_restrain_in_both_attachments)
{
    for (const bool reversed : {false, true}) {
        Rig::place(a, {0, 0, 0});
        const dJointID j = dJointCreateAMotor(rig.id(), nullptr);
        reversed ? Rig::join(j, nullptr, a) : Rig::join(j, a);
        dJointSetAMotorMode(j, dAMotorEuler);
        dJointSetAMotorAxis(j, 0, 1, 1, 0, 0);
        dJointSetAMotorAxis(j, 2, 2, 0, 0, 1);
        dJointSetAMotorParam(j, dParamLoStop, Real(-0.1));
        dJointSetAMotorParam(j, dParamHiStop, Real(0.1));
        Rig::place(a, {0, 0, 0}, turn(kX, Real(0.2)));
        const Emitted e = rig.emit(j);
        ASSERT_EQ(e.rows.size(), 1u);
        EXPECT_NEAR(e.rows[0].ang1.x, 1, kNear);
        EXPECT_NEAR(rig.c(e.rows[0]), -2, 1e-4) << "back towards the range";
    }
}

TEST_F(Readings, user_motor_stores_axes_where_they_are_fixed)
{
    const dJointID j = dJointCreateAMotor(rig.id(), nullptr);
    Rig::join(j, a, b);
    dJointSetAMotorNumAxes(j, 2);
    dJointSetAMotorAxis(j, 0, 1, 0, 2, 0);
    dJointSetAMotorAxis(j, 1, 2, 0, 0, 1);
    Rig::place(a, {0, 0, 0}, turn(kZ, kPi / 2));
    dJointGetAMotorAxis(j, 0, r);
    EXPECT_NEAR(r[0], -1, kNear);
    dJointSetAMotorAngle(j, 1, Real(0.5));
    dJointSetAMotorParam(j, dParamHiStop2, Real(0.4));
    const Emitted e = rig.emit(j);
    ASSERT_EQ(e.rows.size(), 1u);
    EXPECT_NEAR(e.rows[0].error, -0.1, kNear);
    dJointAddAMotorTorques(j, 1, 2, 4);
    EXPECT_NEAR(b->tacc[0], 1, kNear);
    EXPECT_NEAR(b->tacc[2], -2, kNear) << "the third axis is not in use";
    dJointSetAMotorNumAxes(j, 4);
    EXPECT_EQ(dJointGetAMotorNumAxes(j), 2);
    dJointSetAMotorAxis(j, 3, 0, 1, 0, 0);
    EXPECT_EQ(dJointGetAMotorAngle(j, -1), 0);
}

TEST_F(Readings, are_taken_once_from_the_same_numbers)
{
    int taken = 0;
    Reading<Vec3, Real> length2_of;
    const auto read = [&](Vec3 v) { return length2_of.of(v, [&] { return ++taken, length2(v); }); };
    EXPECT_EQ(read({}), 0);
    EXPECT_EQ(read({}), 0);
    EXPECT_EQ(taken, 1);
    EXPECT_EQ(read({3, 4, 0}), 25);
    EXPECT_EQ(read({3, 4, 0}), 25);
    EXPECT_EQ(taken, 2);
    EXPECT_EQ(read({3, 4, Real(-0.0)}), 25);  // an angle may depend on the sign of a zero
    EXPECT_EQ(taken, 3);
}

// What a joint remembers of readings must not show: the last one is that of a joint that was read just once.
TEST_F(Readings, do_not_depend_on_those_before)
{
    const auto last = [&](dJointID j, bool between, Vec3& angles) {
        Rig::place(a, {0, 0, 0}, turn({1, 2, 3}, Real(0.4))),
            Rig::place(b, {2, 0, 0}, turn({3, -1, 1}, Real(0.3)));
        const bool motor = dJointGetType(j) == dJointTypeAMotor;
        const auto read = [&] {
            for (int i = 0; i < dJointGetNumAxes(j); ++i) angles.set(i, dJointGetAxisPosition(j, i));
        };
        const auto change = [&](auto&& make) {
            make();
            if (between) read();
        };
        change([&] { Rig::join(j, a, b); });
        change([&] { motor ? dJointSetAMotorMode(j, dAMotorEuler) : dJointSetUniversalAnchor(j, 1, 0, 0); });
        change([&] { motor ? dJointSetAMotorAxis(j, 0, 1, 1, 0, 0) : dJointSetUniversalAxis1(j, 0, 1, 0); });
        change([&] { motor ? dJointSetAMotorAxis(j, 2, 2, 0, 0, 1) : dJointSetUniversalAxis2(j, 0, 0, 1); });
        change([&] { Rig::place(b, {2, 0, 0}, turn({0, 1, 1}, Real(0.9))); });
        change([&] { Rig::place(a, {1, 0, 0}, turn({1, 0, 1}, Real(-0.5))); });
        read();
    };
    for (const auto create : {dJointCreateUniversal, dJointCreateAMotor}) {
        Vec3 once, often;
        last(create(rig.id(), nullptr), false, once), last(create(rig.id(), nullptr), true, often);
        EXPECT_GT(length(once), Real(0.3));
        EXPECT_EQ(once, often);
    }
}

TEST_F(Readings, wrong_types_stale_handles_and_bad_numbers_change_nothing)
{
    const dJointID ball = dJointCreateBall(rig.id(), nullptr), hinge = dJointCreateHinge(rig.id(), nullptr);
    Rig::join(hinge, a);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    EXPECT_EQ(dJointGetHingeAngle(ball), 0);
    EXPECT_EQ(dJointGetHingeAngle(nullptr), 0);
    EXPECT_EQ(dJointGetSliderPosition(hinge), 0);
    dJointSetHingeAxis(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, std::numeric_limits<Real>::quiet_NaN(), 0, 1);
    dJointGetHingeAxis(hinge, r);
    EXPECT_EQ(r[2], 1);
    dJointSetHingeAnchor(hinge, kInf, 0, 0);
    dJointGetHingeAnchor(hinge, r);
    EXPECT_EQ(r[0], 0);
    dJointGetHingeAnchor(hinge, nullptr);
    dJointAddHingeTorque(hinge, kInf);
    EXPECT_EQ(a->tacc[2], 0);
    destroy_joint(*from_handle<Joint>(ball));
    dJointSetBallAnchor(ball, 1, 2, 3);
    EXPECT_EQ(dJointGetBallParam(ball, dParamERP), 0);
    EXPECT_EQ(dJointCreateBall(nullptr, nullptr), nullptr);
}

TEST_F(Readings, readings_of_a_joint_without_bodies_are_zero)
{
    const dJointID hinge = dJointCreateHinge(rig.id(), nullptr),
                   slider = dJointCreateSlider(rig.id(), nullptr);
    const dJointID universal = dJointCreateUniversal(rig.id(), nullptr);
    EXPECT_EQ(dJointGetHingeAngle(hinge) + dJointGetHingeAngleRate(hinge), 0);
    EXPECT_EQ(dJointGetSliderPosition(slider) + dJointGetSliderPositionRate(slider), 0);
    EXPECT_EQ(dJointGetUniversalAngle1(universal) + dJointGetUniversalAngle2Rate(universal), 0);
    dJointAddHingeTorque(hinge, 1);
    dJointAddSliderForce(slider, 1);
    dJointAddUniversalTorques(universal, 1, 1);
    dJointSetSliderAxis(slider, 1, 0, 0);
}

}  // namespace
}  // namespace epode::test
