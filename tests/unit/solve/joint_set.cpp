// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints in lanes: the kernels of every machine leave the bits of the formulas written down here for one
// joint, an island has the same answer alone and packed with others, and what a visit leaves is what the rows
// ask for. Lanes of floats are held to the same, to their digits; where Real is float, to the same bits.
#include <gtest/gtest.h>

#include <vector>

#include "joint_mechanisms.h"
#include "solve/common/residual.h"

namespace {

using namespace epode_test;

// One joint, number by number: the formulas of solve/joints/joint_kernels.inc in their order.
class OneJoint {
  public:
    OneJoint(Problem& p, const RowBlock& block) : p_(p), block_(block), form_(block.form)
    {
        for (int pass = 0; pass < 2; ++pass)
            for (int i = 0; i < block.count; ++i) {
                const RowNumbers& n = p.numbers[std::size_t(block.first + i)];
                const bool bounded = n.lo > -kInf || n.hi < kInf;
                if (bounded && i < 3) form_ = RowForm::kFree;
                if (bounded == (pass == 1)) order_.push_back(std::size_t(block.first + i));
                if (bounded && pass == 0) ++bounded_;
            }
        a_ = p.bodies[std::size_t(block.body1)];
        if (block.body2 >= 0) b_ = p.bodies[std::size_t(block.body2)];
        factor();
    }

    Answer visits(int sweeps, JointSweep how)
    {
        apply(impulses_);
        for (int i = 0; i < sweeps; ++i) visit(how.w);
        Answer out;
        for (const SolverBody& body : p_.bodies) out.velocities.push_back({body.v, 0, body.w, 0});
        out.velocities[std::size_t(block_.body1)] = {a_.v, 0, a_.w, 0};
        if (block_.body2 >= 0) out.velocities[std::size_t(block_.body2)] = {b_.v, 0, b_.w, 0};
        out.velocities.push_back({});
        out.numbers = p_.numbers;
        for (std::size_t i = 0; i < order_.size(); ++i) out.numbers[order_[i]].p = impulses_[i];
        return out;
    }

  private:
    const Row& row(std::size_t i) const { return p_.rows[order_[i]]; }
    const RowNumbers& numbers(std::size_t i) const { return p_.numbers[order_[i]]; }
    std::size_t rows() const { return order_.size(); }
    std::size_t free() const { return order_.size() - std::size_t(bounded_); }

    Jacobian jacobian(std::size_t i) const
    {
        const bool two = block_.body2 >= 0;
        if (form_ == RowForm::kFree)
            return {row(i).lin1, row(i).ang1, two ? row(i).lin2 : Vec3{}, two ? row(i).ang2 : Vec3{}};
        if (i >= 3) return {{}, row(i).ang1, {}, Vec3{} - row(i).ang1};
        const Vec3 d = row(i).lin1;
        return {d, cross(block_.arms.r1, d), Vec3{} - d, cross(d, block_.arms.r2)};
    }

    void fill_matrix()
    {
        A_.assign(rows(), std::vector<Real>(rows()));
        for (std::size_t i = 0; i < rows(); ++i)
            for (std::size_t j = 0; j <= i; ++j)
                A_[i][j] = form_ == RowForm::kFree ? entry(i, j) : point_entry(i, j);
    }

    Real entry(std::size_t i, std::size_t j) const
    {
        const Jacobian x = jacobian(i), y = jacobian(j);
        return (dot(y.lin1, a_.inv_mass * x.lin1) + dot(y.ang1, a_.inv_inertia * x.ang1)) +
               (dot(y.lin2, b_.inv_mass * x.lin2) + dot(y.ang2, b_.inv_inertia * x.ang2));
    }

    Real point_entry(std::size_t i, std::size_t j) const
    {
        const auto direction = [&](std::size_t k) { return k < 3 ? row(k).lin1 : row(k).ang1; };
        const Vec3 r1 = block_.arms.r1, r2 = block_.arms.r2, d = direction(i);
        const Vec3 t1 = a_.inv_inertia * (i < 3 ? cross(r1, d) : d);
        const Vec3 t2 = b_.inv_inertia * (i < 3 ? cross(r2, d) : d);
        const Vec3 across = cross(t1, r1) + cross(t2, r2);
        if (j >= 3) return dot(direction(j), t1 + t2);
        const Real sum = form_ == RowForm::kTurned ? dot(direction(j), across) : across[int(j)];
        return i == j ? (a_.inv_mass + b_.inv_mass) + sum : sum;
    }

    void factor()
    {
        const std::size_t n = rows();
        std::vector<Real> whole;
        fill_matrix();
        for (std::size_t i = 0; i < n; ++i) {
            A_[i][i] += numbers(i).C;
            whole.push_back(A_[i][i]);
            const Real p = whole[i] > 0 ? numbers(i).p : 0;
            impulses_.push_back(i < free() ? p : clip(p, i));
        }
        for (std::size_t k = 0; k < free(); ++k) pivot(k, whole[k]);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                if (i < free())
                    A_[i][j] = -A_[i][j];
                else if (i == j)
                    A_[i][i] = A_[i][i] - 64 * kEpsilon * whole[i] > 0 ? 1 / A_[i][i] : 0;
                A_[j][i] = A_[i][j];
            }
    }

    void pivot(std::size_t k, Real whole)
    {
        const Real inverse = A_[k][k] - 64 * kEpsilon * whole > 0 ? 1 / A_[k][k] : 0;
        const auto at = [&](std::size_t i, std::size_t j) -> Real& { return i > j ? A_[i][j] : A_[j][i]; };
        std::vector<Real> column;
        for (std::size_t i = 0; i < rows(); ++i) column.push_back(at(i, k));
        for (std::size_t i = 0; i < rows(); ++i) {
            if (i == k) continue;
            const Real share = column[i] * inverse;
            for (std::size_t j = 0; j <= i; ++j)
                if (j != k) A_[i][j] = A_[i][j] - share * column[j];
            at(i, k) = share;
        }
        A_[k][k] = -inverse;
    }

    Real clip(Real x, std::size_t i) const
    {
        x = x > numbers(i).hi ? numbers(i).hi : x;
        return x < numbers(i).lo ? numbers(i).lo : x;
    }

    Real velocity(std::size_t i) const
    {
        if (form_ == RowForm::kFree) {
            const Jacobian J = jacobian(i);
            return (dot(J.lin1, a_.v) + dot(J.ang1, a_.w)) + (dot(J.lin2, b_.v) + dot(J.ang2, b_.w));
        }
        if (i >= 3) return dot(row(i).ang1, a_.w - b_.w);
        const Vec3 u = (a_.v - b_.v) + (cross(a_.w, block_.arms.r1) - cross(b_.w, block_.arms.r2));
        if (form_ == RowForm::kTurned) return dot(row(i).lin1, u);
        return i == 0 ? u.x : i == 1 ? u.y : u.z;
    }

    void apply(const std::vector<Real>& p)
    {
        Vec3 f1, t1, f2, t2, couple;
        if (form_ == RowForm::kFree) {
            for (std::size_t i = 0; i < rows(); ++i) {
                const Jacobian J = jacobian(i);
                f1 += p[i] * J.lin1, t1 += p[i] * J.ang1, f2 += p[i] * J.lin2, t2 += p[i] * J.ang2;
            }
        } else {
            f1 = {p[0], p[1], p[2]};
            if (form_ == RowForm::kTurned) f1 = p[0] * row(0).lin1 + p[1] * row(1).lin1 + p[2] * row(2).lin1;
            for (std::size_t i = 3; i < rows(); ++i) couple += p[i] * row(i).ang1;
            t1 = cross(block_.arms.r1, f1) + couple;
            f2 = Vec3{} - f1;
            t2 = Vec3{} - (cross(block_.arms.r2, f1) + couple);
        }
        a_.v += a_.inv_mass * f1, a_.w += a_.inv_inertia * t1;
        b_.v += b_.inv_mass * f2, b_.w += b_.inv_inertia * t2;
    }

    void visit(Real w)
    {
        const std::size_t n = rows(), f = free();
        std::vector<Real> x, rest(n), q(n), dp(n);
        for (std::size_t i = 0; i < n; ++i)
            x.push_back(w * (numbers(i).c - velocity(i) - numbers(i).C * impulses_[i]));
        for (std::size_t j = f; j < n; ++j) {
            rest[j] = x[j];
            for (std::size_t k = 0; k < f; ++k) rest[j] -= A_[j][k] * x[k];
        }
        for (int pass = 0; pass < (bounded_ > 1 ? 2 : bounded_); ++pass)
            for (std::size_t j = f; j < n; ++j) {
                Real wanted = rest[j];
                for (std::size_t k = f; k < n; ++k)
                    if (k < j || (k > j && pass > 0)) wanted -= A_[j][k] * dp[k];
                q[j] = clip(impulses_[j] + A_[j][j] * wanted, j);
                dp[j] = q[j] - impulses_[j];
            }
        for (std::size_t i = 0; i < f; ++i) {
            dp[i] = A_[i][0] * x[0];
            for (std::size_t k = 1; k < f; ++k) dp[i] += A_[i][k] * x[k];
            for (std::size_t j = f; j < n; ++j) dp[i] -= A_[j][i] * dp[j];
        }
        for (std::size_t i = 0; i < n; ++i) impulses_[i] = i < f ? impulses_[i] + dp[i] : q[i];
        apply(dp);
    }

    Problem& p_;
    const RowBlock block_;
    RowForm form_;
    int bounded_ = 0;
    std::vector<std::size_t> order_;  // of the rows, free ones first
    SolverBody a_, b_{};
    std::vector<std::vector<Real>> A_;
    std::vector<Real> impulses_;
};

TEST(JointKernels, all_machines_make_the_bits_of_the_formulas)
{
    const auto all = joint_kernels();
    ASSERT_STREQ(all[0]->name, "baseline");
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Problem p = mechanism(seed, 2, 0);
        Dice dice(seed + 1000);
        add_joint(p, dice, 0, seed % 4 ? 1 : -1, RowForm(seed % 3), seed % 5 == 0);
        const Answer expected = OneJoint(p, p.blocks[0]).visits(3, kSweep);
        for (const JointKernels* kernels : all) {
            SCOPED_TRACE(kernels->name);
            SCOPED_TRACE(seed);
            expect_same(expected, solve<Lanes>(*kernels, p, 3));
            if (kSingle) expect_same(expected, solve<FloatLanes>(*kernels, p, 3));
        }
    }
}

template <typename L>
void expect_same_bits_of_mechanisms()
{
    const auto all = joint_kernels();
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Problem p = mechanism(seed, seed == 8 ? 90 : 200, 600, seed == 8);
        const Answer expected = solve<L>(*all[0], p, 5);
        for (const JointKernels* other : all.subspan(1)) {
            SCOPED_TRACE(other->name);
            expect_same(expected, solve<L>(*other, p, 5));
        }
    }
}

TEST(JointKernels, all_machines_make_the_same_bits_of_mechanisms)
{
    if (joint_kernels().size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
    expect_same_bits_of_mechanisms<Lanes>();
    expect_same_bits_of_mechanisms<FloatLanes>();
}

// From velocities that floats hold, a sweep over Reals and one over floats make the same impulses.
TEST(JointKernels, sweeps_over_rounded_velocities_are_the_same)
{
    Problem p = mechanism(3, 120, 0);
    Dice dice(3);
    for (int i = 0; i < 120; i += 2) add_joint(p, dice, i, i % 6 ? i + 1 : -1, RowForm(i / 2 % 3), false);
    const RowSystem system = p.system();
    for (const JointKernels* kernels : joint_kernels()) {
        SCOPED_TRACE(kernels->name);
        Arena arena;
        FloatJointSet sets[2] = {FloatJointSet(*kernels), FloatJointSet(*kernels)};
        for (FloatJointSet& set : sets) {
            ASSERT_TRUE(set.pack(system, joints_of(system), arena));
            set.load(system);
        }
        std::vector<FloatVelocity> rounded(p.bodies.size() + 1);
        std::vector<Velocity> velocities(rounded.size());
        for (std::size_t i = 0; i < rounded.size(); ++i)
            for (int k = 0; k < kTwistNumbers; ++k) {
                rounded[i].at[k] = k % 4 == 3 ? 0 : float(dice.real(-1, 1));
                numbers(velocities[i])[k] = rounded[i].at[k];
            }
        sets[0].sweep(velocities, kSweep), sets[1].sweep(rounded, kSweep);
        std::vector<RowNumbers> a = p.numbers, b = p.numbers;
        sets[0].store_impulses(a), sets[1].store_impulses(b);
        for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].p, b[i].p) << i;
        for (std::size_t i = 0; i < rounded.size(); ++i)
            for (int k = 0; k < kTwistNumbers; ++k)
                EXPECT_EQ(float(numbers(velocities[i])[k]), rounded[i].at[k]) << i;
    }
}

template <typename L>
void expect_same_answer_alone_and_packed()
{
    Problem together;
    std::vector<Problem> islands;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const Problem p = mechanism(seed, 3 + int(seed), 2 + int(seed));
        islands.push_back(p);
        append(together, p);
    }
    const JointKernels& kernels = *joint_kernels().back();
    const Answer packed = solve<L>(kernels, together, 4);
    std::size_t body = 0, row = 0;
    for (const Problem& p : islands) {
        expect_same(solve<L>(kernels, p, 4), packed, body, row);
        body += p.bodies.size(), row += p.rows.size();
    }
}

TEST(JointSet, an_island_has_the_same_answer_alone_and_packed)
{
    expect_same_answer_alone_and_packed<Lanes>();
    expect_same_answer_alone_and_packed<FloatLanes>();
}

template <typename L>
void expect_that_a_visit_solves_a_joint()
{
    int at_bounds = 0, within = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Problem p = mechanism(seed, 2, 0);
        Dice dice(seed + 500);
        add_joint(p, dice, 0, seed % 4 ? 1 : -1, RowForm(seed % 3), false);
        int bounded = 0;
        for (const RowNumbers& n : p.numbers) bounded += n.lo > -kInf || n.hi < kInf;
        const Answer answer = solve<L>(*joint_kernels().back(), p, bounded > 1 ? 5000 : 1, {1, false});
        for (std::size_t i = 0; i < p.bodies.size(); ++i)
            p.bodies[i].v = answer.velocities[i].v, p.bodies[i].w = answer.velocities[i].w;
        const SolverBody* b = p.blocks[0].body2 >= 0 ? &p.bodies[1] : nullptr;
        for (std::size_t i = 0; i < p.rows.size(); ++i) {
            SCOPED_TRACE(seed);
            const RowNumbers& n = answer.numbers[i];
            const Real gap = row_velocity(p.rows[i], p.bodies[0], b) + n.C * n.p - n.c;
            const Real tolerance = kCoarse<L> ? Real(2e-2) : Real(1e-7);
            const auto held = [](Real x) { return Real(typename L::Number(x)); };  // as lanes hold it
            const Real lo = held(n.lo), hi = held(n.hi);
            EXPECT_GE(n.p, lo);
            EXPECT_LE(n.p, hi);
            if (n.p > lo) { EXPECT_LT(gap, tolerance); }
            if (n.p < hi) { EXPECT_GT(gap, -tolerance); }
            if (n.lo > -kInf || n.hi < kInf) ++(n.p > lo && n.p < hi ? within : at_bounds);
        }
    }
    EXPECT_GT(at_bounds, 30);
    EXPECT_GT(within, 30);
}

// One visit with W = 1 to a joint alone leaves its free rows satisfied, and one bounded row is where it
// belongs; several are by repeated visits.
TEST(JointSet, a_visit_solves_a_joint)
{
    expect_that_a_visit_solves_a_joint<Lanes>();
    expect_that_a_visit_solves_a_joint<FloatLanes>();
}

template <typename L>
void expect_that_repeated_rows_share_the_answer()
{
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Dice dice(seed);
        Problem p;
        p.body({0, 0, 0}, 1), p.body({1, 0, 0}, 2);
        p.bodies[0].v = dice.vec(1), p.bodies[1].w = dice.vec(1);
        std::vector<Row> of;
        const int rank = 1 + dice.below(5);
        for (int i = 0; i < 6; ++i) {
            Row row;
            if (i < rank)
                row.lin1 = dice.vec(1), row.ang1 = dice.vec(1), row.lin2 = dice.vec(1),
                row.ang2 = dice.vec(1);
            else
                static_cast<Jacobian&>(row) = of[std::size_t(dice.below(rank))];
            of.push_back(row);
        }
        p.block(0, 1, false, of);
        const Answer answer = solve<L>(*joint_kernels().back(), p, 2, {1, false});
        for (std::size_t i = 0; i < p.bodies.size(); ++i)
            p.bodies[i].v = answer.velocities[i].v, p.bodies[i].w = answer.velocities[i].w;
        for (const Row& row : p.rows)
            EXPECT_NEAR(row_velocity(row, p.bodies[0], &p.bodies[1]), 0, kCoarse<L> ? 1e-2 : 1e-8) << seed;
    }
}

TEST(JointSet, rows_that_repeat_others_share_the_answer)
{
    expect_that_repeated_rows_share_the_answer<Lanes>();
    expect_that_repeated_rows_share_the_answer<FloatLanes>();
}

// The general form of the same rows ends in the same place.
TEST(JointSet, forms_are_only_shorter_ways_to_write_rows)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Problem p = mechanism(seed, 12, 14), general = p;
        for (RowBlock& block : general.blocks) block.form = RowForm::kFree;
        const JointKernels& kernels = *joint_kernels().back();
        const Answer a = solve<Lanes>(kernels, p, 10), b = solve<Lanes>(kernels, general, 10);
        for (std::size_t i = 0; i < p.bodies.size(); ++i) {
            EXPECT_LT(max_component(abs(a.velocities[i].v - b.velocities[i].v)), kSingle ? 5e-2 : 1e-8)
                << seed;
            EXPECT_LT(max_component(abs(a.velocities[i].w - b.velocities[i].w)), kSingle ? 5e-2 : 1e-8)
                << seed;
        }
    }
}

}  // namespace
