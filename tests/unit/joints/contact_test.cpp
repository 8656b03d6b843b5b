// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What each bit of dSurfaceParameters.mode does to the rows; numbers measured on ODE 0.16.2 for a unit mass
// on a contact at its centre, normal z, h = 0.01, ERP 0.2.
#include <gtest/gtest.h>

#include "ode/contact.h"
#include "ode/objects.h"
#include "rig.h"

namespace epode::test {
namespace {

struct ContactRows : testing::Test {
    Rig rig;
    Body* b = rig.body({0, 0, 0});
    dContact contact{};

    void SetUp() override { contact.geom.normal[2] = 1; }
    std::vector<Row> rows(bool reversed = false)
    {
        const dJointID j = dJointCreateContact(rig.id(), nullptr, &contact);
        reversed ? Rig::join(j, nullptr, b) : Rig::join(j, b);
        return rig.emit(j).rows;
    }
    Real c() { return rig.c(rows()[0]); }
    dSurfaceParameters& surface() { return contact.surface; }
};

TEST_F(ContactRows, depth_is_removed_at_the_rate_of_erp)
{
    contact.geom.depth = Real(0.1);
    Rig::velocity(b, {0, 0, -1});
    EXPECT_NEAR(c(), 2, 1e-5);
    const Row normal = rows()[0];
    EXPECT_EQ(normal.kind, RowKind::kNormal);
    EXPECT_EQ(normal.lo, 0);
    EXPECT_EQ(normal.hi, kInf);
    EXPECT_FALSE(normal.soft);
}

TEST_F(ContactRows, the_world_caps_the_correction_and_keeps_a_layer)
{
    contact.geom.depth = Real(0.1);
    rig.info.contact_max_vel = Real(0.5);
    EXPECT_EQ(c(), Real(0.5));
    rig.info.contact_max_vel = kInf;
    rig.info.contact_layer = Real(0.05);
    EXPECT_NEAR(c(), 1, 1e-5);
    rig.info.contact_layer = 1;
    EXPECT_EQ(c(), 0);
}

TEST_F(ContactRows, motion_along_the_normal_adds_up_under_the_cap)
{
    contact.geom.depth = Real(0.1);
    surface().mode = dContactMotionN;
    surface().motionN = 3;
    EXPECT_NEAR(c(), 5, 1e-5);
    rig.info.contact_max_vel = Real(0.5);
    EXPECT_EQ(c(), Real(0.5));
}

TEST_F(ContactRows, bounce_ignores_the_cap_and_slow_impacts)
{
    surface().mode = dContactBounce;
    surface().bounce = Real(0.5);
    surface().bounce_vel = Real(0.1);
    Rig::velocity(b, {0, 0, -4});
    EXPECT_EQ(c(), 2);
    rig.info.contact_max_vel = Real(0.5);
    EXPECT_EQ(c(), 2);
    surface().bounce_vel = 5;
    EXPECT_EQ(c(), 0);
    surface().bounce_vel = -1;
    EXPECT_EQ(c(), 0);
    surface().bounce_vel = Real(0.1);
    surface().mode |= dContactMotionN;
    surface().motionN = 1;
    EXPECT_EQ(c(), Real(3.5));
}

TEST_F(ContactRows, soft_contacts_take_their_own_erp_and_cfm)
{
    contact.geom.depth = Real(0.1);
    surface().mode = dContactSoftERP | dContactSoftCFM;
    surface().mu = 1;
    surface().soft_erp = Real(0.1);
    surface().soft_cfm = Real(0.01);
    const std::vector<Row> r = rows();
    const RowNumbers n = ode_baumgarte(r[0], rig.info.h, 0);
    EXPECT_NEAR(n.c / (1 + n.C), 0.5, 1e-5) << "the velocity of a free unit mass";
    EXPECT_TRUE(r[0].soft);
    EXPECT_EQ(r[1].cfm, rig.info.cfm) << "friction stays as hard as the world";
}

TEST_F(ContactRows, friction_is_a_force_or_a_share_of_the_normal_force)
{
    surface().mu = 3;
    std::vector<Row> r = rows();
    ASSERT_EQ(r.size(), 3u);
    EXPECT_EQ(r[1].parent, -1);
    EXPECT_EQ(r[1].lo, -3);
    EXPECT_EQ(r[1].hi, 3);
    EXPECT_EQ(r[1].kind, RowKind::kFriction);
    surface().mode = dContactApprox1_2;
    r = rows();
    EXPECT_EQ(r[1].parent, -1);
    EXPECT_EQ(r[2].parent, 0);
    EXPECT_EQ(r[2].hi, 3);
    surface().mu = kInf;
    EXPECT_EQ(rows()[1].hi, kInf);
    surface().mu = -1;
    EXPECT_EQ(rows().size(), 1u);
}

TEST_F(ContactRows, mu2_counts_only_with_its_bit)
{
    surface().mu = 0;
    surface().mu2 = 7;
    EXPECT_EQ(rows().size(), 1u);
    surface().mode = dContactMu2;
    const std::vector<Row> r = rows();
    ASSERT_EQ(r.size(), 2u);
    EXPECT_EQ(r[1].hi, 7);
    Vec3 p, q;
    plane_space({0, 0, 1}, p, q);
    EXPECT_TRUE(r[1].lin1 == q);
}

TEST_F(ContactRows, fdir1_is_taken_as_given_even_reversed)
{
    surface().mode = dContactFDir1;
    surface().mu = 1;
    contact.fdir1[1] = 2;
    std::vector<Row> r = rows();
    EXPECT_TRUE(r[1].lin1 == (Vec3{0, 2, 0}));
    EXPECT_TRUE(r[2].lin1 == (Vec3{-2, 0, 0}));
    r = rows(true);
    EXPECT_TRUE(r[0].lin1 == (Vec3{0, 0, -1}));
    EXPECT_TRUE(r[1].lin1 == (Vec3{0, 2, 0}));
    EXPECT_TRUE(r[2].lin1 == (Vec3{2, 0, 0}));
}

TEST_F(ContactRows, motion_and_slip_belong_to_their_directions)
{
    surface().mode = dContactMotion1 | dContactSlip2;
    surface().mu = 100;
    surface().motion1 = Real(0.5);
    surface().slip2 = Real(0.01);
    const std::vector<Row> r = rows();
    EXPECT_EQ(rig.c(r[1]), Real(0.5));
    EXPECT_EQ(r[1].cfm, rig.info.cfm);
    EXPECT_EQ(rig.c(r[2]), 0);
    EXPECT_EQ(r[2].cfm, Real(0.01));
    EXPECT_TRUE(r[2].soft);
}

TEST_F(ContactRows, rolling_rows_turn_about_both_tangents_and_the_normal)
{
    surface().mode = dContactRolling | dContactApprox1_N;
    surface().rho = Real(0.3);
    std::vector<Row> r = rows();
    ASSERT_EQ(r.size(), 4u);
    Vec3 p, q;
    plane_space({0, 0, 1}, p, q);
    EXPECT_TRUE(r[1].ang1 == p && r[2].ang1 == q && r[3].ang1 == (Vec3{0, 0, 1}));
    for (int i = 1; i < 4; ++i) {
        EXPECT_EQ(length2(r[i].lin1), 0);
        EXPECT_EQ(r[i].hi, Real(0.3));
    }
    EXPECT_EQ(r[1].parent, -1);
    EXPECT_EQ(r[3].parent, 0);
    surface().mode |= dContactAxisDep;
    surface().rho2 = 0;
    surface().rhoN = Real(0.7);
    r = rows();
    ASSERT_EQ(r.size(), 3u) << "no row for a coefficient of zero";
    EXPECT_EQ(r[2].hi, Real(0.7));
}

TEST_F(ContactRows, refuses_numbers_it_would_read_and_ignores_the_others)
{
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    surface().motion1 = surface().soft_cfm = surface().mu2 = contact.fdir1[0] = nan;
    EXPECT_EQ(rows().size(), 1u);
    surface().mode = dContactMotion1;
    EXPECT_EQ(dJointCreateContact(rig.id(), nullptr, &contact), nullptr);
    surface().mode = 0;
    contact.geom.depth = nan;
    EXPECT_EQ(dJointCreateContact(rig.id(), nullptr, &contact), nullptr);
    contact.geom.depth = 0;
    contact.geom.normal[2] = 0;
    EXPECT_EQ(dJointCreateContact(rig.id(), nullptr, &contact), nullptr);
    EXPECT_EQ(dJointCreateContact(rig.id(), nullptr, nullptr), nullptr);
    EXPECT_EQ(dJointCreateContact(nullptr, nullptr, &contact), nullptr);
}

}  // namespace
}  // namespace epode::test
