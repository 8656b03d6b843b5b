// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints of trees, eliminated from the leaves: what is found satisfies the equations, and loops are refused.
#include "solve/substeps/joint_forest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "systems.h"

namespace {

using namespace epode_test;

// Bodies, of which some cannot move, and joints between them with random rows.
struct Joints {
    explicit Joints(int bodies) : bodies_(std::size_t(bodies))
    {
        for (SolverBody& body : bodies_) {
            body.inv_mass = dice.real(Real(0.01), 10);
            const Real a = dice.real(1, 20), b = dice.real(1, 20), c = dice.real(1, 20);
            body.inv_inertia = {a, b, c, Real(0.2), Real(-0.1), Real(0.3)};
        }
        system.bodies = bodies_;
    }
    void fix(int body) { bodies_[std::size_t(body)] = {}; }
    void join(int a, int b, int count, Real C = 0)
    {
        NetworkJoint joint{};
        joint.first = int(rows.size()), joint.count = count;
        joint.body[0] = a, joint.body[1] = b;
        joint.inv_mass[0] = bodies_[std::size_t(a)].inv_mass,
        joint.inv_mass[1] = bodies_[std::size_t(b)].inv_mass;
        list.push_back(joint);
        for (int i = 0; i < count; ++i) rows.push_back(random_row(joint, C));
    }
    bool is_forest()
    {
        EXPECT_TRUE(forest.build(system, list, arena));
        return forest.is_forest();
    }
    std::vector<double> random_numbers();  // one a row
    std::vector<double> solve(std::vector<double> x);
    // The largest |r - J dv - C dp| of rows in the factor, over the largest |r|.
    double error();

    Dice dice{7};
    RowSystem system;
    std::vector<NetworkJoint> list;
    std::vector<NetworkRow> rows;
    JointForest forest;
    Arena arena;

  private:
    NetworkRow random_row(const NetworkJoint& joint, Real C);
    double velocity(const NetworkJoint& joint, const NetworkRow& row, const std::vector<Vec3>& v,
                    const std::vector<Vec3>& w) const;

    std::vector<SolverBody> bodies_;
};

NetworkRow Joints::random_row(const NetworkJoint& joint, Real C)
{
    NetworkRow row{};
    const auto vec = [&] { return Vec3{dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1)}; };
    row.lin[0] = vec(), row.lin[1] = -row.lin[0];
    row.ang[0] = vec(), row.ang[1] = vec();
    for (int side = 0; side < 2; ++side)
        row.turn[side] = bodies_[std::size_t(joint.body[side])].inv_inertia * row.ang[side];
    row.C = C, row.parent = -1, row.place = RowPlace::kFactor;
    return row;
}

double Joints::velocity(const NetworkJoint& joint, const NetworkRow& row, const std::vector<Vec3>& v,
                        const std::vector<Vec3>& w) const
{
    double sum = 0;
    for (int side = 0; side < 2; ++side) {
        const auto b = std::size_t(joint.body[side]);
        sum += double(dot(row.lin[side], v[b]) + dot(row.ang[side], w[b]));
    }
    return sum;
}

std::vector<double> Joints::solve(std::vector<double> x)
{
    std::vector<NetworkJoint> sorted;
    for (const int j : forest.order()) sorted.push_back(list[std::size_t(j)]);
    EXPECT_TRUE(forest.prepare(sorted, arena));
    for (std::size_t t = 0; t < forest.bundles().size(); ++t) {
        forest.factor(system, t, sorted, rows);
        forest.solve(t, sorted, x);
    }
    return x;
}

std::vector<double> Joints::random_numbers()
{
    std::vector<double> r(rows.size());
    for (double& number : r) number = double(dice.real(-1, 1));
    return r;
}

double Joints::error()
{
    const std::vector<double> r = random_numbers(), x = solve(r);
    std::vector<Vec3> v(bodies_.size()), w(bodies_.size());
    const auto for_rows = [&](auto&& f) {
        for (const NetworkJoint& joint : list)
            for (int i = joint.first; i < joint.first + joint.count; ++i)
                if (rows[std::size_t(i)].place == RowPlace::kFactor) f(joint, std::size_t(i));
    };
    for_rows([&](const NetworkJoint& joint, std::size_t i) {
        for (int side = 0; side < 2; ++side) {
            const auto b = std::size_t(joint.body[side]);
            v[b] += (joint.inv_mass[side] * Real(x[i])) * rows[i].lin[side];
            w[b] += Real(x[i]) * rows[i].turn[side];
        }
    });
    double worst = 0;
    for_rows([&](const NetworkJoint& joint, std::size_t i) {
        worst = std::max(worst, std::fabs(r[i] - velocity(joint, rows[i], v, w) - double(rows[i].C) * x[i]));
    });
    return worst;
}

// Rows get a billionth of their diagonal element (kFirm), in floats there are seven digits.
constexpr double kClose = kSingle ? 1e-3 : 1e-6;

TEST(JointForest, solves_a_figure_with_limbs)
{
    Joints joints(16);
    const int parents[] = {0, 0, 1, 2, 3, 3, 5, 3, 7, 0, 9, 10, 0, 12, 13};
    for (int i = 0; i < 15; ++i) joints.join(i + 1, parents[i], 3 + i % 3);
    ASSERT_TRUE(joints.is_forest());
    EXPECT_EQ(joints.forest.bundles().size(), 1u);
    EXPECT_LT(joints.error(), kClose);
}

TEST(JointForest, solves_trees_that_hang_and_trees_that_fly)
{
    Joints joints(12);
    joints.fix(0);
    joints.join(1, 0, 5), joints.join(2, 1, 4), joints.join(1, 3, 3);             // hang on what cannot move
    joints.join(0, 4, 6), joints.join(5, 4, 3);                                   // the other way round
    joints.join(7, 6, 3), joints.join(8, 7, 5, Real(0.1)), joints.join(7, 9, 2);  // fly
    ASSERT_TRUE(joints.is_forest());
    EXPECT_EQ(joints.forest.bundles().size(), 1u);  // of eight links
    EXPECT_LT(joints.error(), kClose);
}

// A hub with many joints, each with more rows than a body has freedoms of motion: a part of them is soft.
TEST(JointForest, solves_a_star_and_soft_rows)
{
    Joints joints(40);
    for (int i = 1; i < 40; ++i)
        joints.join(i, 0, i % 2 ? 5 : JointForest::kMaxRows, i % 2 ? Real(0) : Real(0.5));
    ASSERT_TRUE(joints.is_forest());
    EXPECT_LT(joints.error(), kClose);
}

TEST(JointForest, has_the_same_bits_by_the_kernels_of_every_machine)
{
    std::vector<double> wanted;
    for (const ForestKernels* kernels : forest_kernels()) {
        Joints joints(16);
        const int parents[] = {0, 0, 1, 2, 3, 3, 5, 3, 7, 0, 9, 10, 0, 12, 13};
        for (int i = 0; i < 15; ++i) joints.join(i + 1, parents[i], 3 + i % 4, i % 5 ? Real(0) : Real(0.1));
        ASSERT_TRUE(joints.is_forest());
        joints.forest.use(*kernels);
        const std::vector<double> found = joints.solve(joints.random_numbers());
        if (wanted.empty()) wanted = found;
        EXPECT_EQ(std::memcmp(found.data(), wanted.data(), sizeof(double) * wanted.size()), 0)
            << kernels->name;
    }
    if (forest_kernels().size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
}

// Eight bodies or more fill the lanes; smaller trees share a bundle.
TEST(JointForest, puts_small_trees_together)
{
    Joints joints(48);
    for (int i = 0; i < 48; i += 3) joints.join(i + 1, i, 3), joints.join(i + 2, i + 1, 5);
    ASSERT_TRUE(joints.is_forest());
    EXPECT_EQ(joints.forest.bundles().size(), 6u);  // nine bodies each, and what is left
    EXPECT_LT(joints.error(), kClose);
}

TEST(JointForest, leaves_rows_out_of_the_factor)
{
    Joints joints(9);
    for (int i = 1; i < 9; ++i) joints.join(i, i - 1, 5);
    for (std::size_t i = 0; i < joints.rows.size(); i += 3)
        joints.rows[i].place = i % 2 ? RowPlace::kSwept : RowPlace::kLeft;
    for (std::size_t i = 20; i < 25; ++i) joints.rows[i].place = RowPlace::kLeft;  // a joint without rows
    ASSERT_TRUE(joints.is_forest());
    EXPECT_LT(joints.error(), kClose);
}

TEST(JointForest, refuses_loops)
{
    const auto refused = [](auto&& make) {
        Joints joints(6);
        joints.fix(0), joints.fix(5);
        make(joints);
        return !joints.is_forest();
    };
    EXPECT_TRUE(refused([](Joints& j) { j.join(1, 2, 3), j.join(2, 3, 3), j.join(3, 1, 3); }));
    EXPECT_TRUE(refused([](Joints& j) { j.join(1, 2, 3), j.join(2, 1, 3); }));
    EXPECT_TRUE(refused([](Joints& j) { j.join(1, 1, 3); }));
    EXPECT_TRUE(refused([](Joints& j) { j.join(0, 5, 3); }));  // nothing moves
    EXPECT_TRUE(refused([](Joints& j) { j.join(1, 0, 3), j.join(1, 2, 3), j.join(2, 5, 3); }));
    EXPECT_TRUE(refused([](Joints& j) { j.join(1, 0, 3), j.join(1, 5, 3); }));
    EXPECT_FALSE(refused([](Joints& j) { j.join(1, 0, 3), j.join(2, 5, 3), j.join(3, 2, 3); }));
}

}  // namespace
