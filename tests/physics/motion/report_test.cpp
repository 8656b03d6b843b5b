// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The step report against what is known of the scene: energies in closed form, errors as they were set up,
// sums over islands, and structs of other sizes than today's.
#include <algorithm>
#include <tuple>
#include <vector>

#include "rig.h"

namespace epode::physics {
namespace {

dIslandStepReport island(const Sim& sim, int index)
{
    dIslandStepReport r{};
    r.struct_size = sizeof r;
    EXPECT_EQ(dWorldGetIslandStepReport(sim.world, index, &r), 1);
    return r;
}

class Report : public testing::Test {
  protected:
    Report() { dWorldSetStepReportMode(sim.world, 1); }
    Sim sim;
};

TEST_F(Report, energy_is_that_of_motion_and_weight)
{
    sim.gravity(0, 0, -10);
    const dBodyID b = sim.body({1, 2, 3}, 2, 4);
    velocity(b, {1, 0, 2}, {0, 3, 0});
    sim.advance(0.01);
    const dWorldStepReport r = sim.report();
    EXPECT_NEAR(r.energy_before, 0.5 * 2 * 5 + 0.5 * 4 * 9 + 2 * 10 * 3, tol(1e-12, 1e-4));
    EXPECT_NEAR(r.energy_after, energy(sim), tol(1e-12, 1e-4));
    dBodySetGravityMode(b, 0);
    sim.advance(0.01);
    EXPECT_NEAR(sim.report().energy_before, kinetic_energy(b), tol(1e-12, 1e-4)) << "it has no weight";
}

TEST_F(Report, errors_are_those_of_the_pose_at_the_beginning)
{
    const dBodyID a = sim.body({0, 0, 0}), b = sim.body({1, 0, 0});
    const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, a, b);
    dJointSetHingeAnchor(hinge, real(0.5), 0, 0);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    place(b, {1.25, 0, 0});
    dQuaternion tilt;
    dQFromAxisAndAngle(tilt, 1, 0, 0, real(0.01));
    dBodySetQuaternion(b, tilt);
    const dBodyID c = sim.body({0, 5, 0});
    const dContact touch = make_contact({0, 5, -1}, {0, 0, 1}, 0.125);
    dJointAttach(dJointCreateContact(sim.world, sim.contacts, &touch), c, nullptr);
    sim.advance(0.01);
    const dWorldStepReport r = sim.report();
    EXPECT_NEAR(r.joint_error, 0.25, tol(1e-12, 1e-6));
    EXPECT_NEAR(r.joint_angle_error, std::sin(0.01), tol(1e-12, 1e-6));
    EXPECT_NEAR(r.penetration, 0.125, tol(1e-12, 1e-6));
    ASSERT_EQ(r.islands, 2);
    EXPECT_EQ(island(sim, 0).body, c) << "from the youngest body on";
    EXPECT_EQ(island(sim, 0).joint_error, 0);
    EXPECT_EQ(island(sim, 1).penetration, 0);
    EXPECT_EQ(island(sim, 1).rows, 5);
}

// The residual is a share of what joints had to change. Where manifolds change the bodies in between, that is part
// of it: without, joints were reported to be off by 1e15 of what they had to do when these two bodies land.
TEST_F(Report, residual_of_substeps_knows_what_manifolds_did)
{
    for (const int substeps : {2, 4, 8}) {
        Sim pair;
        dWorldSetStepReportMode(pair.world, 1);
        pair.gravity(0, 0, -9.81);
        dWorldSetContactSpace(pair.world, pair.space);
        pair.ground();
        const dBodyID a = pair.capsule({0, 0, 1}, 0.1, 0.5, 3);
        const dBodyID b = pair.box({0.4, 0, 1.03}, {0.4, 0.2, 0.2}, 1);
        const dJointID ball = dJointCreateBall(pair.world, nullptr);
        dJointAttach(ball, a, b);
        dJointSetBallAnchor(ball, real(0.15), 0, 1);
        velocity(a, {0, 0.1, 0}, {0.5, 0.2, 0});  // so that there is something to do in the air
        double worst = 0;
        for (int i = 0; i < 200; ++i) {
            ASSERT_EQ(dWorldStepFast1(pair.world, real(0.01), substeps), 1);
            worst = std::max(worst, pair.report().residual);
        }
        EXPECT_LT(position(a).z, 0.5) << "landed";
        EXPECT_GT(worst, 0);
        EXPECT_LT(worst, 10) << substeps;
    }
}

TEST_F(Report, the_whole_is_the_sum_of_its_islands)
{
    sim.gravity(0, 0, -9.81);
    sim.ground();
    for (int i = 0; i < 5; ++i) sim.box({3.0 * i, 0, 0.499}, {1, 1, 1}, 1 + i);
    sim.body({0, 0, 9});
    sim.steps(3, 0.01);
    const dWorldStepReport r = sim.report();
    ASSERT_EQ(r.islands, 6);
    int rows = 0, bodies = 0, dense_or_sparse = 0, free = 0;
    double before = 0, residual = 0;
    for (int i = 0; i < r.islands; ++i) {
        const dIslandStepReport one = island(sim, i);
        rows += one.rows, bodies += one.bodies, before += one.energy_before;
        residual = std::max(residual, one.residual);
        free += one.method == dIslandMethodNone;
        dense_or_sparse += one.method == dIslandMethodDense || one.method == dIslandMethodActiveSet;
        EXPECT_FALSE(one.contained);
    }
    EXPECT_EQ(rows, r.rows);
    EXPECT_EQ(bodies, 6);
    EXPECT_EQ(before, r.energy_before);
    EXPECT_EQ(residual, r.residual);
    EXPECT_EQ(free, 1);
    EXPECT_EQ(dense_or_sparse, 5) << "boxes at rest need no fallback";
}

TEST_F(Report, names_the_method_of_each_stepper)
{
    sim.ground();
    sim.gravity(0, 0, -9.81);
    sim.box({0, 0, 0.49}, {1, 1, 1}, 1);
    sim.stepper = Stepper::kQuick;
    sim.step(0.01);
    EXPECT_EQ(island(sim, 0).method, dIslandMethodSweeps);
    sim.stepper = Stepper::kFast;
    sim.step(0.01);
    EXPECT_EQ(island(sim, 0).method, dIslandMethodSubsteps);
}

TEST_F(Report, an_island_that_is_not_there_is_refused)
{
    sim.body({0, 0, 0});
    sim.advance(0.01);
    dIslandStepReport r{};
    r.struct_size = sizeof r;
    Messages messages;
    EXPECT_EQ(dWorldGetIslandStepReport(sim.world, 1, &r), 0);
    EXPECT_EQ(dWorldGetIslandStepReport(sim.world, -1, &r), 0);
    EXPECT_EQ(dWorldGetIslandStepReport(sim.world, 0, nullptr), 0);
    EXPECT_EQ(messages.count(), 3);
    r.struct_size = 8;  // an older program: only what fits is written
    r.body = nullptr;
    EXPECT_EQ(dWorldGetIslandStepReport(sim.world, 0, &r), 1);
    EXPECT_EQ(r.body, nullptr);
    EXPECT_EQ(r.struct_size, 8u);
}

TEST_F(Report, of_a_size_that_no_version_has_is_refused)
{
    sim.body({0, 0, 0});
    sim.advance(0.01);
    dWorldStepReport r{};
    Messages messages;
    int refused = 0;
    for (const unsigned size : {0u, 4u, 9u, unsigned(sizeof r + 8), ~0u}) {
        r.struct_size = size;
        EXPECT_EQ(dWorldGetStepReport(sim.world, &r), 0) << size;
        EXPECT_EQ(messages.count(), ++refused);
        EXPECT_EQ(r.islands, 0);
    }
    r.struct_size = sizeof r;
    EXPECT_EQ(dWorldGetStepReport(sim.world, &r), 1);
    EXPECT_EQ(r.islands, 1);
}

// Equations without compliance that contradict each other have no solution: what an exact step leaves of them is in its
// residual, and one of those that cause it is named. What else the island holds is not.
// Parameters: what contradicts, and exact substeps.
class Contradiction : public testing::TestWithParam<std::tuple<int, int>> {
  protected:
    Contradiction()
    {
        dWorldSetStepReportMode(sim.world, 1);
        dWorldSetCFM(sim.world, 0);
        dWorldSetExactSubsteps(sim.world, std::get<1>(GetParam()));
        sim.gravity(0, 0, -9.81);
    }
    static int kind() { return std::get<0>(GetParam()); }
    dJointID joined(dJointID joint, dBodyID a, dBodyID b)
    {
        dJointAttach(joint, a, b);
        return joint;
    }
    dJointID ball(dBodyID a, dBodyID b, V3 at)
    {
        const dJointID joint = joined(dJointCreateBall(sim.world, nullptr), a, b);
        dJointSetBallAnchor(joint, real(at.x), real(at.y), real(at.z));
        return joint;
    }
    dJointID fixed(dBodyID a, dBodyID b)
    {
        const dJointID joint = joined(dJointCreateFixed(sim.world, nullptr), a, b);
        dJointSetFixed(joint);
        return joint;
    }
    // Two bodies fixed to each other twice, a rod between two anchors, a motor on a body that is fixed: `wrong` of them.
    std::vector<dJointID> build(int kind, bool wrong, double by = 1)
    {
        const dBodyID a = sim.body({0, 0, 1}), b = sim.body({1, 0, 1}), other = sim.body({2, 0, 1});
        bystander = ball(b, other, {1.5, 0, 1});
        if (kind == 0) {
            const dJointID first = fixed(a, b);
            if (wrong) place(b, {1 + 0.1 * by, 0, 1});
            const dJointID second = fixed(a, b);
            return {first, second};
        }
        if (kind == 1) {
            const dJointID first = ball(a, nullptr, {-0.5, 0, 1}), middle = ball(a, b, {0.5, 0, 1}),
                           last = ball(b, nullptr, {1.5, 0, 1});
            if (wrong) place(a, {-0.1 * by, 0, 1});
            if (wrong) dJointSetBallAnchor(middle, real(0.5 - 0.1 * by), 0, 1);
            if (wrong) place(b, {1 + 0.1 * by, 0, 1});
            return {first, middle, last};
        }
        const dJointID hinge = joined(dJointCreateHinge(sim.world, nullptr), a, b);
        dJointSetHingeAnchor(hinge, real(0.5), 0, 1);
        dJointSetHingeAxis(hinge, 0, 0, 1);
        dJointSetHingeParam(hinge, dParamVel, real(wrong ? 2 * by : 0));
        dJointSetHingeParam(hinge, dParamFMax, dInfinity);
        return {hinge, fixed(a, b)};
    }
    Sim sim;
    dJointID bystander = nullptr;
};

TEST_P(Contradiction, is_in_the_residual_and_named)
{
    const std::vector<dJointID> all = build(kind(), true);
    sim.advance(0.01);
    const dWorldStepReport world = sim.report();
    const dIslandStepReport one = island(sim, 0);
    EXPECT_GT(world.residual, 0.01);
    EXPECT_EQ(one.residual, world.residual);
    EXPECT_EQ(one.contained, 0);
    EXPECT_NE(std::find(all.begin(), all.end(), one.unsolved_joint), all.end());
    EXPECT_EQ(world.unsolved_joint, one.unsolved_joint);
    EXPECT_GE(one.unsolved_joints, 1);
    EXPECT_LE(one.unsolved_joints, int(all.size()));
    EXPECT_EQ(world.unsolved_joints, one.unsolved_joints);
}

#if !defined(dSINGLE)
// By a nanometre or less, which is little even of what the weights make of a step, but more than a step promises.
TEST_P(Contradiction, is_named_as_soon_as_a_step_is_not_exact)
{
    build(kind(), true, kind() == 1 ? 1e-8 : 5e-12);
    sim.advance(0.01);
    const dWorldStepReport world = sim.report();
    EXPECT_GT(world.residual, 1e-9);
    EXPECT_LT(world.residual, 1e-6);
    EXPECT_GE(world.unsolved_joints, 1);
    EXPECT_NE(world.unsolved_joint, nullptr);
}
#endif

TEST_P(Contradiction, is_not_seen_where_there_is_none)
{
    build(kind(), false);
    for (int i = 0; i < 50; ++i) {
        sim.advance(0.01);
        const dWorldStepReport world = sim.report();
        EXPECT_LT(world.residual, tol(1e-9, 1e-3)) << i;
        EXPECT_EQ(world.unsolved_joint, nullptr);
        EXPECT_EQ(world.unsolved_joints, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Contradiction, testing::Combine(testing::Range(0, 3), testing::Values(1, 3)));

TEST_F(Report, thread_counts_out_of_range_are_refused)
{
    Messages messages;
    dWorldSetStepThreads(sim.world, 4);
    dWorldSetStepThreads(sim.world, -1);
    dWorldSetStepThreads(sim.world, 65);
    EXPECT_EQ(dWorldGetStepThreads(sim.world), 4);
    EXPECT_EQ(messages.count(), 2);
}

}  // namespace
}  // namespace epode::physics
