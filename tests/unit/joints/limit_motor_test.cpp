// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Stops, motor, bounce and fudge on a slider to the world: mass 1, h = 0.01, axis x.
#include <gtest/gtest.h>

#include "ode/objects.h"
#include "rig.h"

namespace epode::test {
namespace {

struct SliderStops : testing::Test {
    Rig rig;
    Body* b = rig.body({0, 0, 0});
    dJointID j = dJointCreateSlider(rig.id(), nullptr);

    void SetUp() override
    {
        Rig::join(j, b);
        dJointSetSliderAxis(j, 1, 0, 0);
    }
    void stops(Real lo, Real hi) { set(dParamLoStop, lo), set(dParamHiStop, hi); }
    void motor(Real vel, Real fmax) { set(dParamVel, vel), set(dParamFMax, fmax); }
    void set(int param, Real value) { dJointSetSliderParam(j, param, value); }
    Emitted at(Real x, Real v = 0)
    {
        Rig::place(b, {x, 0, 0});
        Rig::velocity(b, {v, 0, 0});
        return rig.emit(j);
    }
};

TEST_F(SliderStops, a_free_axis_writes_no_row)
{
    EXPECT_EQ(at(3).rows.size(), 5u);
    stops(-1, 1);
    EXPECT_EQ(at(0.5).rows.size(), 5u);
}

TEST_F(SliderStops, a_motor_wants_its_speed_within_its_force)
{
    motor(2, 50);
    const Emitted e = at(0);
    ASSERT_EQ(e.rows.size(), 6u);
    const Row& r = e.rows[5];
    EXPECT_EQ(rig.c(r), 2);
    EXPECT_EQ(r.lo, -50);
    EXPECT_EQ(r.hi, 50);
    EXPECT_EQ(r.kind, RowKind::kLimit);
    EXPECT_FALSE(e.applied);
}

TEST_F(SliderStops, beyond_a_stop_the_row_pushes_back_only)
{
    stops(-1, 0);
    const Emitted high = at(0.1);
    ASSERT_EQ(high.rows.size(), 6u);
    EXPECT_NEAR(rig.c(high.rows[5]), -2, 1e-5);
    EXPECT_EQ(high.rows[5].lo, -kInf);
    EXPECT_EQ(high.rows[5].hi, 0);
    const Emitted low = at(-1.1);
    ASSERT_EQ(low.rows.size(), 6u);
    EXPECT_NEAR(rig.c(low.rows[5]), 2, 1e-5);
    EXPECT_EQ(low.rows[5].lo, 0);
    EXPECT_EQ(low.rows[5].hi, kInf);
}

TEST_F(SliderStops, at_a_stop_the_motor_pushes_outright)
{
    stops(-1, 0);
    motor(-2, 50);
    Emitted e = at(0);
    ASSERT_TRUE(e.applied);
    EXPECT_EQ(e.force[0].x, -50);
    EXPECT_EQ(rig.c(e.rows[5]), 0);
    set(dParamFudgeFactor, Real(0.25));
    EXPECT_EQ(at(0).force[0].x, Real(-12.5)) << "fudged when pulling away";
    motor(2, 50);
    EXPECT_EQ(at(0).force[0].x, 50) << "not fudged when pushing in";
    motor(0, 50);
    EXPECT_EQ(at(0).force[0].x, 50) << "a holding motor presses against the stop";
    EXPECT_EQ(at(-1).force[0].x, -50);
}

TEST_F(SliderStops, an_unlimited_motor_leaves_a_stop_by_its_row)
{
    stops(-1, 0);
    motor(-2, kInf);
    const Emitted away = at(0);
    EXPECT_FALSE(away.applied);
    ASSERT_EQ(away.rows.size(), 6u);
    EXPECT_EQ(rig.c(away.rows[5]), -2);
    motor(2, kInf);
    const Emitted into = at(0);
    EXPECT_FALSE(into.applied);
    EXPECT_EQ(into.rows[5].hi, 0);
    EXPECT_EQ(rig.c(into.rows[5]), 0);
}

TEST_F(SliderStops, equal_stops_are_a_servo_that_ignores_the_motor)
{
    stops(0, 0);
    motor(5, 50);
    const Emitted e = at(0.1);
    ASSERT_EQ(e.rows.size(), 6u);
    EXPECT_NEAR(rig.c(e.rows[5]), -2, 1e-5);
    EXPECT_EQ(e.rows[5].lo, -kInf);
    EXPECT_EQ(e.rows[5].hi, kInf);
    EXPECT_FALSE(e.applied);
}

TEST_F(SliderStops, crossed_or_unreachable_stops_do_nothing)
{
    stops(1, -1);
    EXPECT_EQ(at(0).rows.size(), 5u);
    stops(kInf, kInf);
    EXPECT_EQ(at(0).rows.size(), 5u);
    stops(-kInf, -kInf);
    EXPECT_EQ(at(0).rows.size(), 5u);
}

TEST_F(SliderStops, a_removed_stop_is_forgotten)
{
    stops(-1, 0);
    EXPECT_EQ(at(0.1).rows.size(), 6u);
    stops(-kInf, kInf);
    EXPECT_EQ(at(0.1).rows.size(), 5u);
}

TEST_F(SliderStops, bounce_returns_a_share_of_the_speed)
{
    stops(-1, 0);
    set(dParamBounce, 0.5);
    EXPECT_EQ(rig.c(at(0, 4).rows[5]), -2);
    EXPECT_EQ(rig.c(at(0, -4).rows[5]), 0) << "already leaving";
    EXPECT_EQ(rig.c(at(-1, -4).rows[5]), 2);
}

TEST_F(SliderStops, softness_of_stop_and_motor_are_their_own)
{
    stops(-1, 0);
    set(dParamStopERP, 0.5);
    set(dParamStopCFM, 0.25);
    set(dParamCFM, 0.125);
    motor(1, 1);
    const Row stop = at(0.1).rows[5], powered = at(-0.5).rows[5];
    EXPECT_NEAR(rig.c(stop), -5, 1e-5);
    EXPECT_EQ(stop.cfm, Real(0.25));
    EXPECT_TRUE(stop.soft);
    EXPECT_EQ(powered.cfm, Real(0.125));
    EXPECT_TRUE(powered.soft);
}

TEST_F(SliderStops, the_state_of_the_step_is_kept_at_inner_poses)
{
    stops(-1, 0);
    motor(-2, 50);
    set(dParamBounce, 0.5);
    at(0.1, 4);
    rig.info.inner = true;
    const Emitted left = at(-0.5, 0);
    ASSERT_EQ(left.rows.size(), 6u);
    EXPECT_NEAR(left.rows[5].error, 0.5, 1e-6);
    EXPECT_EQ(left.rows[5].hi, 0);
    EXPECT_EQ(left.rows[5].restitution_velocity, -2) << "of the impact, not of the inner velocity";
    EXPECT_FALSE(left.applied);
    rig.info.inner = false;
    EXPECT_EQ(at(-0.5).rows[5].hi, 50);
}

TEST_F(SliderStops, refuses_what_no_parameter_can_be)
{
    motor(1, 2);
    set(dParamVel, std::numeric_limits<Real>::quiet_NaN());
    set(dParamVel, kInf);
    EXPECT_EQ(dJointGetSliderParam(j, dParamVel), 1);
    set(dParamFMax, -3);
    EXPECT_EQ(dJointGetSliderParam(j, dParamFMax), 2);
    set(dParamFudgeFactor, Real(1.5));
    EXPECT_EQ(dJointGetSliderParam(j, dParamFudgeFactor), 1);
    EXPECT_EQ(dJointGetSliderParam(j, dParamHiStop), kInf);
    EXPECT_EQ(dJointGetSliderParam(j, dParamERP), 0) << "unknown to a slider";
    EXPECT_EQ(dJointGetSliderParam(j, dParamVel2), 0);
}

}  // namespace
}  // namespace epode::test
