// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A row with ERP = h k/(h k + d) and CFM = 1/(h k + d) is a spring k with damper d, integrated implicitly:
//   m (v' - v)/h = f - k (x + h v') - d v',   x' = x + h v'.
// Both bounded (a stop with lo = hi) and unilateral (a soft contact), the recurrence holds to rounding. The
// small-step method keeps k and d, not the recurrence: it is held to the motion of the continuous spring.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

struct Spring {
    double mass, k, d, f;

    double erp(double h) const { return h * k / (h * k + d); }
    double cfm(double h) const { return 1 / (h * k + d); }
    double next_speed(double x, double v, double h) const
    {
        return (mass * v + h * f - h * k * x) / (mass + h * h * k + h * d);
    }
    double force(double x, double v, double h) const { return -k * x - (h * k + d) * next_speed(x, v, h); }
};

struct SpringDamper : testing::TestWithParam<Stepper> {
    Sim sim{GetParam()};
    // One row per unknown: with W = 1 the sweep is exact, over-relaxation only goes back and forth.
    SpringDamper() { dWorldSetQuickStepW(sim.world, 1); }

    dBodyID on_slider(const Spring& s, double h)
    {
        dBodyID b = sim.body({0, 0, 0}, s.mass);
        dJointID slider = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(slider, b, nullptr);
        dJointSetSliderAxis(slider, 1, 0, 0);
        dJointSetSliderParam(slider, dParamLoStop, 0);
        dJointSetSliderParam(slider, dParamHiStop, 0);
        dJointSetSliderParam(slider, dParamStopERP, real(s.erp(h)));
        dJointSetSliderParam(slider, dParamStopCFM, real(s.cfm(h)));
        return b;
    }
};

TEST_P(SpringDamper, a_stop_with_erp_and_cfm_is_the_implicit_spring)
{
    if (GetParam() == Stepper::kFast) GTEST_SKIP() << "another recurrence: see below";
    const Spring s{2, 50, 3, 4};
    const double h = 0.02;
    dBodyID b = on_slider(s, h);
    double x = 0.3, v = -1;
    place(b, {x, 0, 0});
    velocity(b, {v, 0, 0});
    for (int i = 0; i < 200; ++i) {
        dBodyAddForce(b, real(s.f), 0, 0);
        ASSERT_EQ(sim.advance(h), 1);
        v = s.next_speed(x, v, h);
        x += h * v;
        // The recurrence contracts, so rounding does not pile up.
        ASSERT_NEAR(position(b).x, x, 100 * kEpsilon) << "step " << i;
        ASSERT_NEAR(velocity(b).x, v, 100 * kEpsilon * 5) << "step " << i;
    }
}

TEST_P(SpringDamper, a_soft_contact_is_the_implicit_spring_in_compression)
{
    if (GetParam() == Stepper::kFast) GTEST_SKIP() << "another recurrence: see below";
    const Spring s{3, 400, 60, -3 * 9.81};
    const double h = 0.01;
    sim.gravity(0, 0, -9.81);
    dBodyID b = sim.body({0, 0, 0}, s.mass);
    double z = -0.2, v = 0;
    place(b, {0, 0, z});
    for (int i = 0; i < 300; ++i) {
        dJointGroupEmpty(sim.contacts);
        dContact c = make_contact(position(b), {0, 0, 1}, -position(b).z);
        c.surface.mode |= dContactSoftERP | dContactSoftCFM;
        c.surface.soft_erp = real(s.erp(h));
        c.surface.soft_cfm = real(s.cfm(h));
        dJointFeedback feedback{};
        dJointID contact = dJointCreateContact(sim.world, sim.contacts, &c);
        dJointAttach(contact, b, nullptr);
        dJointSetFeedback(contact, &feedback);
        const double force = s.force(z, v, h);
        ASSERT_GT(force, 0) << "the test means a contact that stays";
        ASSERT_EQ(sim.advance(h), 1);
        v = s.next_speed(z, v, h);
        z += h * v;
        ASSERT_NEAR(position(b).z, z, 100 * kEpsilon) << "step " << i;
        // Force is an impulse over h: the error of the velocity times m / h.
        ASSERT_NEAR(double(feedback.f1[2]), force, 500 * kEpsilon * s.mass / h) << "step " << i;
    }
    EXPECT_NEAR(z, -3 * 9.81 / 400, 1e-3);
}

TEST_P(SpringDamper, a_spring_gives_way_by_load_over_stiffness)
{
    const Spring s{2, 80, 25, 10};
    const double h = 0.02;
    dBodyID b = on_slider(s, h);
    for (int i = 0; i < 600; ++i) {
        dBodyAddForce(b, real(s.f), 0, 0);
        sim.advance(h);
    }
    EXPECT_NEAR(position(b).x, s.f / s.k, tol(1e-9, 1e-5));
    EXPECT_NEAR(velocity(b).x, 0, tol(1e-9, 1e-5));
}

TEST_P(SpringDamper, a_soft_contact_carries_a_weight_at_depth_mg_over_k)
{
    const Spring s{1.5, 300, 30, 0};
    const double h = 0.01, r = 0.5;
    sim.gravity(0, 0, -9.81);
    sim.surface.mode |= dContactSoftERP | dContactSoftCFM;
    sim.surface.soft_erp = real(s.erp(h));
    sim.surface.soft_cfm = real(s.cfm(h));
    sim.ground();
    dBodyID ball = sim.sphere({0, 0, r}, r, s.mass);
    sim.steps(500, h);
    EXPECT_NEAR(position(ball).z, r - s.mass * 9.81 / s.k, tol(1e-8, 1e-5));
}

// The spring pulled to x0 and let go: largest distance from the continuous solution over two seconds.
double distance_from_continuous(Sim& sim, dBodyID b, const Spring& s, double h)
{
    const double x0 = 0.5, decay = s.d / (2 * s.mass), w = std::sqrt(s.k / s.mass - decay * decay);
    place(b, {x0, 0, 0});
    double worst = 0;
    for (int i = 1, n = int(2 / h + 0.5); i <= n; ++i) {
        sim.advance(h);
        const double t = i * h;
        const double x = x0 * std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
        worst = std::max(worst, std::fabs(position(b).x - x));
    }
    return worst;
}

TEST_P(SpringDamper, oscillates_as_the_continuous_spring_with_short_steps)
{
    const Spring s{1, 40, 1, 0};
    double worst[2];
    for (int k = 0; k < 2; ++k) {
        const double h = k == 0 ? 0.01 : 0.0025;
        Sim each(GetParam());
        each.substeps = 4;
        dBodyID b = each.body({0, 0, 0}, s.mass);
        dJointID slider = dJointCreateSlider(each.world, nullptr);
        dJointAttach(slider, b, nullptr);
        dJointSetSliderAxis(slider, 1, 0, 0);
        dJointSetSliderParam(slider, dParamLoStop, 0);
        dJointSetSliderParam(slider, dParamHiStop, 0);
        dJointSetSliderParam(slider, dParamStopERP, real(s.erp(h)));
        dJointSetSliderParam(slider, dParamStopCFM, real(s.cfm(h)));
        worst[k] = distance_from_continuous(each, b, s, h);
    }
    // Implicit Euler damps like h k / 2 on top of d: 5 % of d 1 at the fine step.
    EXPECT_LT(worst[1], 0.03);
    EXPECT_LT(worst[1], 0.4 * worst[0]) << "first order: a quarter, with room";
}

INSTANTIATE_TEST_SUITE_P(Steppers, SpringDamper, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
