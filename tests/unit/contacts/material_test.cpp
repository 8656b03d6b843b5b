// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What becomes of two materials: every rule, in both orders, the later one of two, and springs one behind the
// other.
#include "contacts/material.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include "base/handle.h"

namespace epode::test {
namespace {

struct Pair {
    dGeomID a = dCreateSphere(nullptr, 1), b = dCreateSphere(nullptr, 1);

    ~Pair() { dGeomDestroy(a), dGeomDestroy(b); }

    ContactManifold of(const dMaterial& m, const dMaterial& n, bool exchanged = false)
    {
        EXPECT_EQ(dGeomSetMaterial(a, &m), 1);
        EXPECT_EQ(dGeomSetMaterial(b, &n), 1);
        Geom &one = *from_handle<Geom>(a), &two = *from_handle<Geom>(b);
        ContactManifold manifold{};
        manifold.normal = {0, 0, 1};
        exchanged ? combine_materials(two, one, manifold) : combine_materials(one, two, manifold);
        return manifold;
    }
};

dMaterial with(double friction, double bounce, double rolling, int rule)
{
    dMaterial m{};
    m.friction = Real(friction), m.bounce = Real(bounce), m.rolling = Real(rolling);
    m.friction_rule = m.bounce_rule = m.rolling_rule = rule;
    return m;
}

TEST(Material, coefficients_follow_the_later_rule_of_the_two)
{
    constexpr int kRules = 5;
    constexpr double kFriction[kRules] = {0.4, 0.5, 0.2, 0.16, 0.8};
    constexpr double kBounce[kRules] = {0.9, 0.5, 0.1, 0.09, 0.9};
    constexpr double kRolling[kRules] = {0.06, 0.04, 0.02, 0.0012, 0.06};
    Pair pair;
    for (int r = 0; r < kRules; ++r)
        for (int s = 0; s < kRules; ++s)
            for (const bool exchanged : {false, true}) {
                SCOPED_TRACE(10 * r + s);
                const int later = std::max(r, s);
                const ContactManifold manifold =
                    pair.of(with(0.2, 0.9, 0.02, r), with(0.8, 0.1, 0.06, s), exchanged);
                EXPECT_NEAR(manifold.mu, kFriction[later], 1e-6);
                EXPECT_NEAR(manifold.restitution, kBounce[later], 1e-6);
                EXPECT_NEAR(manifold.rolling_friction, kRolling[later], 1e-6);
            }
}

TEST(Material, what_cannot_slide_slides_on_what_has_no_friction)
{
    Pair pair;
    dMaterial glue = with(0, 0, 0, dCombineDefault);
    glue.friction = dInfinity;
    for (const int rule : {dCombineDefault, dCombineMinimum, dCombineProduct}) {
        glue.friction_rule = rule;
        EXPECT_EQ(pair.of(glue, with(0, 0, 0, rule)).mu, 0) << rule;
    }
    for (const int rule : {dCombineAverage, dCombineMaximum}) {
        glue.friction_rule = rule;
        EXPECT_EQ(pair.of(glue, with(0, 0, 0, rule)).mu, 1e6f) << rule;
    }
}

TEST(Material, soft_surfaces_are_springs_one_behind_the_other)
{
    Pair pair;
    dMaterial a{}, b{};
    a.softness = Real(1e-3), a.damping_time = Real(0.2);
    b.softness = Real(3e-3), b.damping_time = Real(0.6);
    const ContactManifold both = pair.of(a, b);
    EXPECT_NEAR(both.compliance, 4e-3, 1e-9);
    EXPECT_NEAR(both.damping_time, 0.5, 1e-6);
    b.softness = 0;  // hard: its damping time says nothing
    EXPECT_NEAR(pair.of(a, b).compliance, 1e-3, 1e-9);
    EXPECT_NEAR(pair.of(b, a).damping_time, 0.2, 1e-6);
    a.softness = Real(1e-12);
    EXPECT_FALSE(pair.of(a, b).special());
}

TEST(Material, that_is_not_named_is_the_default)
{
    dMaterial m{};
    Pair pair;
    ASSERT_EQ(dGeomGetMaterial(pair.a, &m), 1);
    EXPECT_EQ(m.friction, Real(0.6));
    EXPECT_EQ(m.rolling, 0);
    EXPECT_EQ(m.softness, 0);
    EXPECT_EQ(m.friction_rule, dCombineDefault);
}

}  // namespace
}  // namespace epode::test
