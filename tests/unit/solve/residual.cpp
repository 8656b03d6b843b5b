// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The yardstick itself, on problems whose answer is known by hand.
#include "solve/common/residual.h"

#include <gtest/gtest.h>

#include "systems.h"

namespace {

using namespace epode_test;

// A unit mass falling on a frictionless floor with v* = -1: the answer is p = 1.
Problem one_contact()
{
    Problem p;
    p.body({0, 0, 0}, 1);
    p.bodies[0].v = {0, 0, -1};
    p.contact(0, -1, {0, 0, 0}, {0, 0, 1}, 0, -1, 0);
    return p;
}

Real residual(Problem& p, Real impulse)
{
    Arena arena;
    p.numbers[0].p = impulse;
    std::vector<Real> lo(p.rows.size()), hi(p.rows.size());
    const RowSystem system = p.system();
    present_bounds(system, lo, hi);
    return natural_residual(system, p.bodies, lo, hi, arena);
}

TEST(Residual, is_zero_at_the_answer_and_the_velocity_error_elsewhere)
{
    Problem p = one_contact();
    EXPECT_EQ(residual(p, 1), 0);
    EXPECT_NEAR(residual(p, 0), 1, 1e-6);
    EXPECT_NEAR(residual(p, Real(1.25)), Real(.25), 1e-6);
}

TEST(Residual, of_a_leaving_contact_is_the_impulse_it_should_not_have)
{
    Problem p = one_contact();
    p.bodies[0].v = {0, 0, 1};
    EXPECT_EQ(residual(p, 0), 0);
    EXPECT_NEAR(residual(p, Real(.5)), Real(.5), 1e-6);
}

TEST(Residual, bounds_follow_the_parent)
{
    Problem p;
    p.body({}, 1);
    p.contact(0, -1, {}, {0, 0, 1}, 0, Real(.5), 0);
    p.contact(0, -1, {}, {0, 0, 1}, 0, kInf, 0);
    p.numbers[0].p = 4;
    Real lo[6], hi[6];
    present_bounds(p.system(), lo, hi);
    EXPECT_EQ(hi[1], 2);
    EXPECT_EQ(lo[1], -2);
    EXPECT_EQ(hi[4], 0);  // no load, no limit to stand on
}

TEST(Residual, no_rows_no_error)
{
    Problem p;
    p.body({}, 1);
    Arena arena;
    EXPECT_EQ(natural_residual(p.system(), p.bodies, {}, {}, arena), 0);
}

}  // namespace
