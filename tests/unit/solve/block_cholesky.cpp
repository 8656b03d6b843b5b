// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The sparse factor against dense arithmetic, and every kind of machine's kernels against the baseline's.
#include "solve/exact/factor/block_cholesky.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "solve/exact/factor/symbolic_cache.h"
#include "systems.h"

namespace {

using namespace epode_test;

std::vector<BodyPair> random_pairs(Dice& dice, int n, int count)
{
    std::vector<BodyPair> pairs;
    for (int i = 0; i < count; ++i) pairs.push_back({dice.below(n), dice.below(n)});
    pairs.push_back({0, 0});
    pairs.push_back(pairs.front());
    return pairs;
}

// Adds B B^T of a random 12x6 B on both bodies, to the sparse and to the dense matrix.
void add_random(Dice& dice, BodyPair pair, BlockCholesky& H, std::vector<double>& dense, int n)
{
    double B[12][6];
    for (auto& row : B)
        for (double& x : row) x = double(dice.real(-1, 1));
    const int body[2] = {pair.a, pair.b};
    const int sides = pair.a == pair.b ? 1 : 2;
    for (int s = 0; s < sides; ++s)
        for (int t = 0; t < sides; ++t) {
            bool transposed = false;
            double* block = s == t ? H.diagonal(body[s]) : H.between(pair.a, pair.b, transposed);
            for (int i = 0; i < 6; ++i)
                for (int j = 0; j < 6; ++j) {
                    double x = 0;
                    for (int k = 0; k < 6; ++k) x += B[6 * s + i][k] * B[6 * t + j][k];
                    dense[std::size_t((6 * body[s] + i) * 6 * n + 6 * body[t] + j)] += x;
                    if (s == t)
                        block[i + 6 * j] += x;
                    else if (s == 0)
                        block[transposed ? j + 6 * i : i + 6 * j] += x;
                }
        }
}

// A random positive definite matrix on random pairs, sparse and dense, with x and H x.
struct System {
    Arena arena;
    SymbolicLease lease;
    BlockCholesky H;
    std::vector<double> dense, wanted, right;

    System(std::uint64_t seed, int n, int pair_count)
    {
        Dice dice(seed);
        const int size = 6 * n;
        const auto pairs = random_pairs(dice, n, pair_count);
        EXPECT_TRUE(lease.take(n, pairs, nullptr, arena));
        EXPECT_TRUE(H.prepare(lease.symbolic(), Tasks(1), arena));
        H.clear();
        dense.assign(std::size_t(size * size), 0);
        for (int b = 0; b < n; ++b)
            for (int i = 0; i < 6; ++i) {
                H.diagonal(b)[7 * i] += 1;
                dense[std::size_t((6 * b + i) * (size + 1))] += 1;
            }
        for (const BodyPair& pair : pairs) add_random(dice, pair, H, dense, n);
        right.assign(std::size_t(size), 0);
        for (int i = 0; i < size; ++i) wanted.push_back(double(dice.real(-1, 1)));
        for (int i = 0; i < size; ++i)
            for (int j = 0; j < size; ++j)
                right[std::size_t(i)] += dense[std::size_t(i * size + j)] * wanted[std::size_t(j)];
    }
};

TEST(BlockCholesky, solves_what_was_assembled)
{
    for (const int n : {1, 2, 3, 4, 5, 7, 10, 15, 25, 50, 100, 200})
        // From loose bodies over trees and meshes to nearly dense.
        for (const int pairs : {0, n - 1, n, 2 * n, 5 * n, n > 25 ? 0 : n * n}) {
            System s(std::uint64_t(n * 31 + pairs), n, pairs);
            EXPECT_EQ(s.H.factor(), 0);
            s.H.solve(s.right);
            for (std::size_t i = 0; i < s.wanted.size(); ++i)
                ASSERT_NEAR(s.right[i], s.wanted[i], 1e-8) << n << " bodies, " << pairs << " pairs";
        }
}

TEST(BlockCholesky, has_the_same_bits_on_every_machine)
{
    for (const int n : {1, 2, 5, 20, 60, 150})
        for (const int pairs : {n - 1, 2 * n, 4 * n}) {
            std::vector<double> first;
            for (const FrontKernels* kernels : front_kernels()) {
                System s(std::uint64_t(n + pairs), n, pairs);
                s.H.use(*kernels);
                s.H.factor();
                s.H.solve(s.right);
                if (first.empty())
                    first = s.right;
                else
                    ASSERT_EQ(first, s.right) << kernels->name << ' ' << n << ' ' << pairs;
            }
        }
}

TEST(BlockCholesky, counts_and_freezes_what_is_not_positive)
{
    const BodyPair pairs[] = {{0, 1}, {1, 2}};
    Arena arena;
    SymbolicLease lease;
    BlockCholesky H;
    ASSERT_TRUE(lease.take(3, pairs, nullptr, arena) && H.prepare(lease.symbolic(), Tasks(1), arena));
    H.clear();
    for (int body = 0; body < 3; ++body)
        for (int i = 0; i < 6; ++i) H.diagonal(body)[7 * i] = body == 1 && i == 2 ? -1 : 2;
    EXPECT_EQ(H.factor(), 1);
    std::vector<double> x(18, 1.0);
    H.solve(x);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], i == 8 ? 0 : 0.5, 1e-15) << i;
    H.clear();
    for (int body = 0; body < 3; ++body)
        for (int i = 0; i < 6; ++i) H.diagonal(body)[7 * i] = body == 2 ? std::nan("") : 2;
    EXPECT_EQ(H.factor(), 6);
}

// H = 1 + sum of B B^T over pairs, too large for a dense matrix.
struct LargeSystem {
    std::vector<BodyPair> pairs;
    std::vector<std::array<double, 72>> B;  // 12 x 6, column by column: first half of body a
    int n;
    Arena arena;
    SymbolicLease lease;
    BlockCholesky H;

    LargeSystem(std::vector<BodyPair> of, int bodies, const Tasks& tasks) : pairs(std::move(of)), n(bodies)
    {
        Dice dice(77);
        B.resize(pairs.size());
        for (auto& one : B)
            for (double& x : one) x = double(dice.real(-1, 1));
        EXPECT_TRUE(lease.take(n, pairs, nullptr, arena) && H.prepare(lease.symbolic(), tasks, arena));
        H.clear();
        for (int b = 0; b < n; ++b)
            for (int i = 0; i < 6; ++i) H.diagonal(b)[7 * i] += 1;
        for (std::size_t k = 0; k < pairs.size(); ++k) add(pairs[k], B[k].data());
    }

    void add(BodyPair pair, const double* b)
    {
        bool transposed = false;
        add_product(H.diagonal(pair.a), b, b);
        add_product(H.diagonal(pair.b), b + 6, b + 6);
        double* between = H.between(pair.a, pair.b, transposed);
        transposed ? add_product(between, b + 6, b) : add_product(between, b, b + 6);
    }

    static void add_product(double* block, const double* x, const double* y)
    {
        for (int r = 0; r < 6; ++r)
            for (int c = 0; c < 6; ++c)
                for (int k = 0; k < 6; ++k) block[r + 6 * c] += x[r + 12 * k] * y[c + 12 * k];
    }

    std::vector<double> times(const std::vector<double>& x) const
    {
        std::vector<double> y = x;
        for (std::size_t k = 0; k < pairs.size(); ++k)
            for (std::size_t c = 0; c < 6; ++c) {
                const double* column = B[k].data() + 12 * c;
                const auto a = std::size_t(6 * pairs[k].a), b = std::size_t(6 * pairs[k].b);
                double s = 0;
                for (std::size_t i = 0; i < 6; ++i) s += column[i] * x[a + i] + column[6 + i] * x[b + i];
                for (std::size_t i = 0; i < 6; ++i) y[a + i] += column[i] * s, y[b + i] += column[6 + i] * s;
            }
        return y;
    }

    std::vector<double> solve(int bad_pivots = 0)
    {
        std::vector<double> x(std::size_t(6 * n));
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = double(i % 17) - 8;
        EXPECT_EQ(H.factor(), bad_pivots);
        H.solve(x);
        return x;
    }
};

std::vector<BodyPair> grid(int side, int depth)
{
    std::vector<BodyPair> pairs;
    for (int v = 0; v < side * side * depth; ++v) {
        if (v % side) pairs.push_back({v - 1, v});
        if (v / side % side) pairs.push_back({v, v - side});
        if (v >= side * side) pairs.push_back({v - side * side, v});
    }
    return pairs;
}

// Two long chains, a wall, a pile, and a chain next to the pile, all too large for one thread.
std::vector<std::pair<std::vector<BodyPair>, int>> large_graphs()
{
    std::vector<BodyPair> chain, comb, loose = grid(9, 4);
    for (int i = 1; i < 3000; ++i) chain.push_back({i - 1, i});
    for (int i = 1; i < 4000; ++i) comb.push_back({i % 8 == 0 ? i - 8 : i - 1, i});
    for (int i = 325; i < 2500; ++i) loose.push_back({i - 1, i});
    return {{chain, 3000}, {comb, 4000}, {grid(24, 1), 576}, {grid(8, 6), 384}, {loose, 2500}};
}

TEST(BlockCholesky, solves_large_systems_by_subtrees)
{
    int cut = 0;
    for (const auto& [pairs, n] : large_graphs()) {
        LargeSystem s(pairs, n, Tasks(1));
        cut += s.lease.symbolic().subtrees.size() >= 2;
        const auto x = s.solve(), back = s.times(x);
        for (std::size_t i = 0; i < back.size(); ++i) ASSERT_NEAR(back[i], double(i % 17) - 8, 1e-8) << n;
    }
    EXPECT_GE(cut, 4);
}

TEST(BlockCholesky, has_the_same_bits_on_any_number_of_threads)
{
    for (const auto& [pairs, n] : large_graphs()) {
        const auto alone = LargeSystem(pairs, n, Tasks(1)).solve();
        for (const int workers : {2, 3, 5, 8})
            EXPECT_EQ(LargeSystem(pairs, n, Tasks(workers)).solve(), alone) << n << " on " << workers;
    }
}

TEST(BlockCholesky, has_the_same_bits_on_every_machine_by_subtrees)
{
    for (const auto& [pairs, n] : large_graphs()) {
        LargeSystem one(pairs, n, Tasks(1)), other(pairs, n, Tasks(2));
        one.H.use(*front_kernels().front());
        other.H.use(*front_kernels().back());
        EXPECT_EQ(one.solve(), other.solve()) << n;
    }
}

TEST(BlockCholesky, counts_bad_pivots_of_all_subtrees)
{
    LargeSystem s(grid(24, 1), 576, Tasks(2));
    int wanted = 0;
    for (int body = 0; body < 576; body += 50, ++wanted) s.H.diagonal(body)[0] = -1e6;
    s.solve(wanted);
}

}  // namespace
