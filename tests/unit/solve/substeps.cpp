// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// StepFast1's substeps on a model of bodies without rotation, whose rows are measured again at every pose,
// against closed forms: the spring-damper that ERP and CFM stand for, rest, rebound, and the sums of
// impulses.
#include <gtest/gtest.h>

#include "solve/common/substep_rows.h"
#include "solve/common/velocities.h"
#include "step/steppers/substep_loop.h"
#include "systems.h"

namespace {

using namespace epode_test;

// Of the last step's impulses, as steps pass on for joints: with all of them, chains that do not converge
// within a step accumulate their error and swing up.
constexpr Real kWarm = Real(0.9);

// Translating bodies; `measure` rewrites the errors of the rows at the present places.
struct Model {
    Problem& p;
    Vec3 gravity;
    void (*measure)(Problem& p) = [](Problem&) {};
    int substeps = 0;

    void apply_forces(std::span<Velocity> bodies, Real h)
    {
        ++substeps;
        for (std::size_t i = 0; i < p.bodies.size(); ++i)
            if (p.bodies[i].inv_mass > 0) bodies[i].v += h * gravity;
    }
    void kick_spins(std::span<Velocity>, Real) {}
    void advance(std::span<const Velocity> bodies, Real h) const
    {
        for (std::size_t i = 0; i < p.places.size(); ++i) p.places[i] += h * bodies[i].v;
    }
    void refresh(std::span<const Velocity>) const { measure(p); }
    void settle() {}
    void gather_contacts() {}

    SolveReport step(int n)
    {
        measure(p);
        for (const RowBlock& block : p.blocks)
            for (int i = block.first; i < block.first + block.count; ++i) {
                const Real kept = kWarm * p.numbers[std::size_t(i)].p;
                p.numbers[std::size_t(i)] = ode_baumgarte(p.rows[std::size_t(i)], p.h, block.first);
                p.numbers[std::size_t(i)].p = kept;
            }
        Arena arena;
        SolveReport report;
        RowSystem system = p.system();
        JointLanes joints(n);
        SubstepSolver<JointLanes> solver(system, n, joints);
        EXPECT_TRUE(solver.prepare({.want_residual = true}, arena));
        EXPECT_TRUE(make_substeps(solver, *this, {}, arena, report));
        return report;
    }
};

constexpr double kTolerance = kSingle ? 1e-4 : 1e-12;

// x'' = -(k x + d x')/m with one implicit step of size h, which is what ERP and CFM promise.
void implicit_spring(double& x, double& v, double k, double d, double m, double h)
{
    v = (v - h * k * x / m) / (1 + h * d / m + h * h * k / m);
    x += h * v;
}

Problem spring(Real k, Real d, Real h)
{
    Problem p;
    p.h = h;
    p.body({Real(0.1), 0, 0}, 2);
    Row row;
    row.lin1 = {1, 0, 0};
    row.erp = h * k / (h * k + d);
    row.cfm = 1 / (h * k + d);
    p.block(0, -1, false, {row});
    return p;
}

TEST(Substeps, substeps_of_a_spring_are_those_of_the_same_spring)
{
    for (const int n : {1, 2, 5}) {
        const Real h = Real(0.02), k = 300, d = 4;
        Problem p = spring(k, d, h);
        Model model{p, {}, [](Problem& q) { q.rows[0].error = -q.places[0].x; }};
        double x = 0.1, v = 0;
        for (int step = 0; step < 20; ++step) {
            model.step(n);
            for (int i = 0; i < n; ++i) implicit_spring(x, v, k, d, 2, h / n);
            EXPECT_NEAR(p.places[0].x, x, 0.1 * kTolerance + 1e-15);
            EXPECT_NEAR(p.bodies[0].v.x, v, 10 * kTolerance);
        }
        EXPECT_EQ(model.substeps, 20 * n);
    }
}

TEST(Substeps, mapping_keeps_spring_and_damper)
{
    const Real h = Real(0.01), k = 1000, d = 20;
    Row row;
    row.erp = h * k / (h * k + d);
    row.cfm = 1 / (h * k + d);
    for (const int n : {1, 3, 10}) {
        const Real hs = h / n;
        const RowAim aim = map_row(row, {hs, n}, 1);
        EXPECT_NEAR(aim.rate * hs, hs * k / (hs * k + d), 1e-6);
        EXPECT_NEAR(aim.C * hs, 1 / (hs * k + d), 1e-6);
    }
    row.erp = 0;  // a motor: its softness is a damper's at any step
    EXPECT_NEAR(map_row(row, {h / 4, 4}, 1).C, row.cfm / (h / 4), 1e-6);
}

TEST(Substeps, feedback_is_the_force_that_holds)
{
    // A body hanging from a rigid ball joint: the impulse of the step is h m g, whatever n.
    for (const int n : {1, 4, 10}) {
        Problem p;
        p.body({0, 0, -1}, 3);
        p.ball(0, -1, {0, 0, -1}, Real(1e-10));
        Model model{p, {0, 0, Real(-9.81)}};
        model.measure = [](Problem& q) { q.rows[2].error = -1 - q.places[0].z; };
        for (int i = 0; i < 10; ++i) model.step(n);
        EXPECT_NEAR(p.numbers[2].p, 3 * 9.81 * p.h, 1e-5);
        EXPECT_NEAR(p.places[0].z, -1, 1e-5);
    }
}

TEST(Substeps, a_falling_box_stops_at_the_floor)
{
    // On one contact exactly. On two, one sweep per pass leaves a few percent of the impact.
    for (const int contacts : {1, 2}) {
        Problem p;
        p.body({0, 0, Real(.5)}, 1);
        p.bodies[0].v = {0, 0, -3};
        for (int i = 0; i < contacts; ++i)
            p.contact(0, -1, {contacts == 1 ? 0 : i - Real(.5), 0, 0}, {0, 0, 1}, 0, Real(.5), Real(1e-9));
        Model model{p, {0, 0, Real(-9.81)}};
        model.step(8);
        EXPECT_EQ(model.substeps, 8);
        EXPECT_NEAR(p.bodies[0].v.z, 0, contacts == 1 ? 1e-4 : 0.12);
        EXPECT_NEAR(p.places[0].z, .5, 1e-3);
        Real total = 0;
        for (int i = 0; i < contacts; ++i) total += p.numbers[std::size_t(3 * i)].p;
        EXPECT_NEAR(total, p.bodies[0].v.z + 3 + 9.81 * p.h, 1e-4);  // what was applied is what is reported
    }
}

TEST(Substeps, rebound_is_what_the_row_says)
{
    Problem p;
    p.body({0, 0, Real(.5)}, 1);
    p.bodies[0].v = {0, 0, -2};
    p.contact(0, -1, {0, 0, 0}, {0, 0, 1}, 0, 0, Real(1e-9));
    p.rows[0].has_restitution = true, p.rows[0].restitution_velocity = Real(1.5);
    Model model{p, {}};
    model.step(5);
    EXPECT_NEAR(p.bodies[0].v.z, 1.5, 1e-5);
}

TEST(Substeps, a_contact_that_is_left_does_not_pull)
{
    Problem p;
    p.body({0, 0, Real(.5)}, 1);
    p.bodies[0].v = {1, 0, 1};
    p.contact(0, -1, {0, 0, 0}, {0, 0, 1}, 0, Real(.5), Real(1e-9));
    Model model{p, {}};
    model.step(4);
    for (const RowNumbers& n : p.numbers) EXPECT_EQ(n.p, 0);
    EXPECT_EQ(p.bodies[0].v.z, 1);
    EXPECT_NEAR(p.places[0].z, .5 + p.h, 1e-6);
}

TEST(Substeps, a_contact_that_opens_may_close_again_exactly)
{
    // Thrown up gently: gravity brings the box back within the step, to the surface and not above it.
    Problem p;
    p.h = Real(0.1);
    p.body({0, 0, Real(.5)}, 1);
    p.bodies[0].v = {0, 0, Real(.2)};
    p.contact(0, -1, {0, 0, 0}, {0, 0, 1}, 0, Real(.5), Real(1e-9));
    Model model{p, {0, 0, -10}};
    model.step(20);
    EXPECT_NEAR(p.places[0].z, .5, 1e-3);
    EXPECT_NEAR(p.bodies[0].v.z, 0, 1e-2);
    EXPECT_GT(p.numbers[0].p, 0);
}

TEST(Substeps, friction_is_bounded_by_the_load)
{
    Problem p;
    p.body({0, 0, Real(.5)}, 1, {1, 1, 1});
    p.bodies[0].v = {5, 0, 0};
    p.bodies[0].inv_inertia = {};  // no turning: a point mass
    p.contact(0, -1, {0, 0, 0}, {0, 0, 1}, 0, Real(.5), Real(1e-9));
    Model model{p, {0, 0, -10}};
    model.step(10);
    EXPECT_NEAR(p.bodies[0].v.x, 5 - .5 * 10 * p.h, 1e-4);
    const Real tangent = std::hypot(p.numbers[1].p, p.numbers[2].p);
    EXPECT_NEAR(tangent, .5 * p.numbers[0].p, 1e-4);
}

TEST(Substeps, force_bounds_of_a_motor_are_forces)
{
    for (const int n : {1, 4}) {
        Problem p;
        p.body({}, 2);
        Row row;
        row.lin1 = {1, 0, 0}, row.kind = RowKind::kLimit, row.speed = 100;
        row.lo = -6, row.hi = 6, row.cfm = Real(1e-9);
        p.block(0, -1, false, {row});
        Model model{p, {}};
        model.step(n);
        EXPECT_NEAR(p.bodies[0].v.x, 6 * p.h / 2, 1e-6);
        EXPECT_NEAR(p.numbers[0].p, 6 * p.h, 1e-6);
    }
}

TEST(Substeps, a_bounded_row_leaves_the_others_of_its_joint_exact)
{
    // A weld with a weak drive: the drive is on its bound, the locked rows still hold.
    Problem p;
    p.body({0, 0, 0}, 1);
    p.body({1, 0, 0}, 50);
    p.bodies[0].v = {1, 2, 3}, p.bodies[1].v = {-1, 0, 1}, p.bodies[1].w = {1, -1, 2};
    std::vector<Row> of;
    for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        of.push_back(p.point_row(0, 1, {Real(.3), Real(.2), 0}, d, 0, Real(1e-12)));
    of[0].kind = RowKind::kLimit, of[0].speed = 10, of[0].lo = -1, of[0].hi = 1;
    p.block(0, 1, false, of);
    Model model{p, {}};
    model.step(1);
    EXPECT_NEAR(p.numbers[0].p, p.h, 1e-6);
    for (std::size_t i = 1; i < 3; ++i)
        EXPECT_NEAR(row_velocity(p.rows[i], p.bodies[0], &p.bodies[1]), 0, kSingle ? 1e-4 : 1e-9);
}

TEST(Substeps, an_unequal_chain_of_ten_holds_together)
{
    Problem p = chain(10, 100);
    for (SolverBody& b : p.bodies) b.v = {};
    Model model{p, {Real(-9.81), 0, 0}};
    model.measure = [](Problem& q) {
        for (std::size_t i = 0; i < q.bodies.size(); ++i)
            q.rows[3 * i].error = (i ? q.places[i - 1].x : Real(-.5)) + 1 - q.places[i].x;
    };
    Real worst = 0;
    for (int step = 0; step < 200; ++step) {
        model.step(10);
        for (std::size_t i = 0; i < p.bodies.size(); ++i)
            worst = std::max(worst, std::fabs(p.places[i].x - Real(i) - Real(.5)));
    }
    EXPECT_LT(worst, 0.02);
}

}  // namespace
