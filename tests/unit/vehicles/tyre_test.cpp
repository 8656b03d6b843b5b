// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The derivatives that Newton's step takes are those of the tyre's functions.
#include "vehicles/tyre.h"

#include <gtest/gtest.h>

namespace epode {
namespace {

constexpr double kApart = kSingle ? 0.02 : 1e-5, kNear = kSingle ? 1e-3 : 1e-8;

TEST(Tyre, secant_has_its_slope_before_and_beyond_sliding)
{
    for (const Real sliding : {Real(1), Real(0.8), Real(0.3)})
        for (const double z : {0.1, 0.5, 0.9, 1.1, 1.5, 2.0, 5.0, 20.0}) {
            const double slope = (double(tyre_secant(Real(z + kApart), sliding)) -
                                  double(tyre_secant(Real(z - kApart), sliding))) /
                                 (2 * kApart);
            EXPECT_NEAR(tyre_secant_slope(Real(z), sliding), slope, kNear) << z << " " << sliding;
        }
}

TEST(Tyre, secant_and_its_slope_go_on_where_sliding_begins)
{
    for (const Real sliding : {Real(1), Real(0.3)}) {
        EXPECT_NEAR(tyre_secant(1, sliding), tyre_secant(Real(1 + 1e-6), sliding), 1e-6);
        EXPECT_NEAR(tyre_secant_slope(1, sliding), tyre_secant_slope(Real(1 + 1e-6), sliding), 1e-5);
    }
}

TEST(Tyre, load_factor_has_its_slope_until_it_is_least)
{
    dVehicleWheel wheel = kDefaultWheel;
    wheel.load_sensitivity = Real(0.5);
    for (const Real load : {Real(1000), Real(4000), Real(9000), Real(30000)}) {
        const Real slope = (load_factor(wheel, load + 10) - load_factor(wheel, load - 10)) / 20;
        EXPECT_NEAR(load_factor_slope(wheel, load), slope, kSingle ? 1e-7 : 1e-12) << load;
    }
}

}  // namespace
}  // namespace epode
