// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Figures in hybrid steps: small trees of equal bodies take substeps where they touch something, and are solved exactly in flight,
// however many they are. Joints that sweeps would not hold are exact in their substeps.
#include "scenes.h"

namespace epode::physics {
namespace {

constexpr double kH = 1.0 / 60;
constexpr int kMany = 60;

// Limbs of three boxes, at random in the game preset, without sleep.
class Limbs : public Sim {
  public:
    Limbs()
    {
        dWorldUseDefaults(world, dDefaultsGame);
        dWorldSetAutoDisableFlag(world, 0);
        dWorldSetContactSpace(world, space);
        dWorldSetStepReportMode(world, 1);
        gravity(0, 0, -9.81);
        ground();
    }
    // The last body.
    dBodyID add(double x, double y, double z, double last_mass = 2)
    {
        const dBodyID a = box({x, y, z}, {0.3, 0.1, 0.1}, 2), b = box({x + 0.35, y, z}, {0.3, 0.1, 0.1}, 2),
                      c = box({x + 0.7, y, z}, {0.3, 0.1, 0.1}, last_mass);
        ball(a, b, {x + 0.175, y, z}), ball(b, c, {x + 0.525, y, z});
        return c;
    }
    double widest_gap() const
    {
        double widest = 0;
        for (dJointID joint : joints_) {
            dVector3 a, b;
            dJointGetBallAnchor(joint, a), dJointGetBallAnchor2(joint, b);
            widest = std::max(widest, length(vec(a) - vec(b)));
        }
        return widest;
    }
    void add_many(double z)
    {
        for (int i = 0; i < kMany; ++i) add(i % 8 * 1.5, i / 8, z);
    }
    void step(int count)
    {
        for (int i = 0; i < count; ++i) EXPECT_EQ(dWorldStepHybrid(world, real(kH)), 1);
    }
    int islands_by(int method)
    {
        int count = 0;
        dIslandStepReport island{};
        island.struct_size = sizeof island;
        for (int i = 0; i < report().islands; ++i) {
            EXPECT_EQ(dWorldGetIslandStepReport(world, i, &island), 1);
            count += island.method == method;
        }
        return count;
    }

  private:
    void ball(dBodyID a, dBodyID b, V3 at)
    {
        joints_.push_back(dJointCreateBall(world, nullptr));
        dJointAttach(joints_.back(), a, b);
        dJointSetBallAnchor(joints_.back(), real(at.x), real(at.y), real(at.z));
    }
    std::vector<dJointID> joints_;
};

TEST(HybridFigures, are_exact_in_flight_however_many)
{
    Limbs limbs;
    limbs.add_many(30);
    limbs.step(20);
    EXPECT_EQ(limbs.islands_by(dIslandMethodSubstepsExactJoints), 0);
    EXPECT_EQ(limbs.islands_by(dIslandMethodSubsteps), 0);
    EXPECT_EQ(limbs.report().islands, kMany);
}

TEST(HybridFigures, take_substeps_where_they_touch)
{
    Limbs limbs;
    limbs.add_many(0.05);
    limbs.step(60);
    EXPECT_EQ(limbs.report().islands, kMany);
    // Half a millisecond is for those that may be exact.
    EXPECT_GT(limbs.islands_by(dIslandMethodSubsteps), kMany / 2);
    EXPECT_EQ(limbs.islands_by(dIslandMethodSubstepsExactJoints), 0);
}

TEST(HybridFigures, with_a_heavy_limb_have_exact_joints)
{
    Limbs limbs;
    for (int i = 0; i < kMany; ++i) limbs.add(i % 8 * 1.5, i / 8, 0.05, 100);
    limbs.step(60);
    EXPECT_EQ(limbs.islands_by(dIslandMethodSubsteps), 0);
    EXPECT_GT(limbs.islands_by(dIslandMethodSubstepsExactJoints), kMany / 2);
}

TEST(HybridFigures, keep_their_joints_closed_in_a_pile)
{
    Limbs limbs;
    for (int i = 0; i < kMany; ++i) limbs.add(i % 3 * 0.4, i / 3 % 3 * 0.3, 0.1 + i / 9 * 0.3);
    limbs.step(240);
    EXPECT_LT(limbs.widest_gap(), 0.003);
}

}  // namespace
}  // namespace epode::physics
