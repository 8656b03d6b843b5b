// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The iterating steppers approach the truth with their iterations: dWorldQuickStep the velocities of
// dWorldStep from the same state (friction bounded by a force, so that both solve one convex problem and its
// velocities are unique), dWorldStepFast1 a chain without gaps although its end weighs a hundred links.
#include <algorithm>
#include <memory>

#include "rig.h"

namespace epode::physics {
namespace {

// A wall of bricks hit by a ball, after `steps` exact steps; contacts of the next one exist.
std::unique_ptr<Sim> wall_after(int steps)
{
    auto sim = std::make_unique<Sim>(Stepper::kExact);
    sim->gravity(0, 0, -9.81);
    sim->surface.mode = dContactApprox0;
    sim->surface.mu = 2;  // newtons
    sim->ground();
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i < 5; ++i)
            sim->box({i * 0.42 + 0.2 * (row % 2), 0, 0.1 + 0.2 * row}, {0.4, 0.2, 0.2}, 1);
    dBodyID ball = sim->sphere({1.0, -1.3, 0.55}, 0.2, 5);
    velocity(ball, {0, 10, 0});
    sim->steps(steps, 0.01);
    sim->collide();
    return sim;
}

double worst_velocity_difference(const Sim& a, const Sim& b)
{
    double worst = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i)
        worst = std::max({worst, length(velocity(a.bodies[i]) - velocity(b.bodies[i])),
                          length(spin(a.bodies[i]) - spin(b.bodies[i]))});
    return worst;
}

TEST(Convergence, of_quick_steps_to_the_exact_step_on_a_wall_being_hit)
{
    for (int steps : {5, 11, 14}) {  // standing, hit, broken
        const auto exact = wall_after(steps);
        ASSERT_GT(exact->contact_count, 50);
        ASSERT_EQ(dWorldStep(exact->world, real(0.01)), 1);
        double before = 0;
        for (int iterations : {10, 100, 1000, 10000}) {
            const auto quick = wall_after(steps);
            dWorldSetStepWarmStarting(quick->world, 0);
            dWorldSetQuickStepNumIterations(quick->world, iterations);
            ASSERT_EQ(dWorldQuickStep(quick->world, real(0.01)), 1);
            const double worst = worst_velocity_difference(*quick, *exact);
            if (iterations > 10) {
                EXPECT_LT(worst, 0.6 * before + tol(1e-8, 1e-3)) << iterations << " after " << steps;
            }
            before = worst;
        }
        // Flying bricks touch in nearly parallel contacts, for which Gauss-Seidel is slow.
        EXPECT_LT(before, steps < 14 ? tol(1e-6, 5e-3) : 5e-3) << "after " << steps;
    }
}

// Worst distance between the anchors of a ball joint over two seconds of a chain falling into hanging.
double worst_gap(int substeps)
{
    Sim sim(Stepper::kFast);
    sim.substeps = substeps;
    sim.gravity(0, 0, -9.81);
    std::vector<dJointID> joints;
    dBodyID before = nullptr;
    for (int i = 0; i < 16; ++i) {
        dBodyID b = sim.body({0.1 + 0.2 * i, 0, 0}, i == 15 ? 100 : 1, i == 15 ? 1 : 0.01);
        dJointID j = dJointCreateBall(sim.world, nullptr);
        dJointAttach(j, b, before);
        dJointSetBallAnchor(j, real(0.2 * i), 0, 0);
        joints.push_back(j);
        before = b;
    }
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        sim.advance(0.01);
        for (dJointID j : joints) {
            dVector3 a, b;
            dJointGetBallAnchor(j, a);
            dJointGetBallAnchor2(j, b);
            worst = std::max(worst, length(vec(a) - vec(b)));
        }
    }
    return worst;
}

TEST(Convergence, of_fast_steps_closes_the_gaps_of_a_chain_with_a_heavy_end)
{
    // Single precision: steps of 0.3 ms at 3 m/s round positions by what they add, times sixteen joints.
    constexpr double kFloor = tol(0, 2e-3);
    double before = 0;
    for (int n : {4, 12, 36}) {
        const double gap = worst_gap(n);
        if (n > 4) {
            EXPECT_LT(gap, 0.5 * before + kFloor) << n << " substeps: second order promises a ninth";
        }
        before = gap;
    }
    EXPECT_LT(before, 2e-3 + kFloor) << "a hundredth of a link";
}

TEST(Convergence, of_quick_steps_reports_a_falling_residual)
{
    double before = 0;
    for (int iterations : {10, 100, 1000}) {
        const auto quick = wall_after(12);
        dWorldSetStepReportMode(quick->world, 1);
        dWorldSetStepWarmStarting(quick->world, 0);
        dWorldSetQuickStepNumIterations(quick->world, iterations);
        dWorldQuickStep(quick->world, real(0.01));
        const double residual = quick->report().residual;
        EXPECT_GT(residual, 0) << "it is measured, not assumed";
        if (iterations > 10) { EXPECT_LT(residual, 0.6 * before + tol(1e-12, 1e-5)); }
        before = residual;
    }
}

}  // namespace
}  // namespace epode::physics
