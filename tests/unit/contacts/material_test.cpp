// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What becomes of two materials: every rule, in both orders, the later one of two, and springs in series.
// What the library takes of a program whose structure has fewer fields, and which sizes it refuses.
#include "contacts/material.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <algorithm>
#include <string>

#include "../api/message_recorder.h"
#include "base/objects/handle.h"

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
        exchanged ? combine_materials(two, one, {}, manifold) : combine_materials(one, two, {}, manifold);
        return manifold;
    }
};

dMaterial with(double friction, double bounce, double rolling, int rule)
{
    dMaterial m{};
    m.struct_size = sizeof m;
    m.friction = Real(friction), m.bounce = Real(bounce), m.rolling_friction = Real(rolling);
    m.friction_rule = m.bounce_rule = m.rolling_friction_rule = rule;
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
    a.struct_size = b.struct_size = sizeof a;
    a.compliance = Real(1e-3), a.damping_time = Real(0.2);
    b.compliance = Real(3e-3), b.damping_time = Real(0.6);
    const ContactManifold both = pair.of(a, b);
    EXPECT_NEAR(both.compliance, 4e-3, 1e-9);
    EXPECT_NEAR(both.damping_time, 0.5, 1e-6);
    b.compliance = 0;  // hard: its damping time says nothing
    EXPECT_NEAR(pair.of(a, b).compliance, 1e-3, 1e-9);
    EXPECT_NEAR(pair.of(b, a).damping_time, 0.2, 1e-6);
    a.compliance = Real(1e-12);
    EXPECT_FALSE(pair.of(a, b).special());
}

TEST(Material, that_is_not_named_is_the_default)
{
    dMaterial m{};
    m.struct_size = sizeof m;
    Pair pair;
    ASSERT_EQ(dGeomGetMaterial(pair.a, &m), 1);
    EXPECT_EQ(m.friction, Real(0.6));
    EXPECT_EQ(m.rolling_friction, 0);
    EXPECT_EQ(m.compliance, 0);
    EXPECT_EQ(m.friction_rule, dCombineDefault);
}

// What a program has that knows no more than friction.
struct OldMaterial {
    unsigned struct_size;
    dReal friction;
    dReal behind;  // not the library's
};

TEST(Material, of_an_older_program_has_defaults_for_the_fields_that_it_does_not_know)
{
    Pair pair;
    OldMaterial old{offsetof(OldMaterial, behind), Real(0.25), 77};
    dMaterial all;
    ASSERT_EQ(dMaterialInit(&all, sizeof all), 1);
    all.bounce = 1, all.compliance = 1;
    ASSERT_EQ(dGeomSetMaterial(pair.a, &all), 1);
    ASSERT_EQ(dGeomSetMaterial(pair.a, reinterpret_cast<const dMaterial*>(&old)), 1);
    ASSERT_EQ(dGeomGetMaterial(pair.a, &all), 1);
    EXPECT_EQ(all.friction, Real(0.25));
    EXPECT_EQ(all.bounce, 0);
    EXPECT_EQ(all.bounce_speed, 1);
    EXPECT_EQ(all.compliance, 0);
    old.friction = 0;
    ASSERT_EQ(dGeomGetMaterial(pair.a, reinterpret_cast<dMaterial*>(&old)), 1);
    EXPECT_EQ(old.friction, Real(0.25));
    EXPECT_EQ(old.behind, 77);
    EXPECT_EQ(old.struct_size, offsetof(OldMaterial, behind));
    ASSERT_EQ(dMaterialInit(reinterpret_cast<dMaterial*>(&old), old.struct_size), 1);
    EXPECT_EQ(old.friction, Real(0.6));
    EXPECT_EQ(old.behind, 77);
}

TEST(Material, of_a_size_that_no_version_has_is_refused_with_the_sizes_that_are_accepted)
{
    Pair pair;
    MessageRecorder recorder;
    const std::string range =
        "from " + std::to_string(2 * sizeof(dReal)) + " to " + std::to_string(sizeof(dMaterial));
    dMaterial m;
    for (const unsigned size : {0u, 4u, unsigned(sizeof m) - 1, unsigned(sizeof m + 8), 4096u, ~0u}) {
        ASSERT_EQ(dMaterialInit(&m, sizeof m), 1);
        m.friction = 5, m.struct_size = size;
        EXPECT_EQ(dGeomSetMaterial(pair.a, &m), 0);
        EXPECT_EQ(dGeomGetMaterial(pair.a, &m), 0);
        EXPECT_EQ(dMaterialInit(&m, size), 0);
        EXPECT_EQ(m.friction, 5);
        const std::string said = recorder.take();
        EXPECT_EQ(std::count(said.begin(), said.end(), '|'), 2) << said;
        EXPECT_NE(said.find("struct_size " + std::to_string(size)), std::string::npos) << said;
        EXPECT_NE(said.find(range), std::string::npos) << said;
    }
    ASSERT_EQ(dMaterialInit(&m, sizeof m), 1);
    ASSERT_EQ(dGeomGetMaterial(pair.a, &m), 1);
    EXPECT_EQ(m.friction, Real(0.6));
}

}  // namespace
}  // namespace epode::test
