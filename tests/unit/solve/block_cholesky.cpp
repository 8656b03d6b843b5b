// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Block-sparse Cholesky against dense arithmetic.
#include "solve/block_cholesky.h"

#include <gtest/gtest.h>

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

TEST(BlockCholesky, SolvesWhatWasAssembled)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Dice dice(seed);
        const int n = 2 + dice.below(25), size = 6 * n;
        const auto pairs = random_pairs(dice, n, 2 * n);
        Arena arena;
        BlockCholesky H;
        ASSERT_TRUE(H.analyse(n, pairs, arena));
        H.clear();
        std::vector<double> dense(std::size_t(size * size));
        for (int b = 0; b < n; ++b)
            for (int i = 0; i < 6; ++i) {
                H.diagonal(b)[7 * i] += 1;
                dense[std::size_t((6 * b + i) * (size + 1))] += 1;
            }
        for (const BodyPair& pair : pairs) add_random(dice, pair, H, dense, n);
        std::vector<double> wanted, x(std::size_t(size), 0.0);
        for (int i = 0; i < size; ++i) wanted.push_back(double(dice.real(-1, 1)));
        for (int i = 0; i < size; ++i)
            for (int j = 0; j < size; ++j)
                x[std::size_t(i)] += dense[std::size_t(i * size + j)] * wanted[std::size_t(j)];
        EXPECT_EQ(H.factor(), 0);
        H.solve(x);
        for (int i = 0; i < size; ++i) EXPECT_NEAR(x[std::size_t(i)], wanted[std::size_t(i)], 1e-9) << seed;
    }
}

}  // namespace
