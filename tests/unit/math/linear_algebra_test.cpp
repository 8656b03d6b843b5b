// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Dense products and factorisations of every size from 1 to beyond the stack buffers, checked by multiplying
// back in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/cholesky.h"
#include "math/ldlt.h"
#include "math/scratch.h"
#include "random_numbers.h"

namespace epode {
namespace {

using Numbers = std::vector<Real>;

Numbers random_numbers(RandomNumbers& random, std::size_t count)
{
    Numbers v(count);
    for (Real& x : v) x = random.in(-1, 1);
    return v;
}

// Element (i, j) of L D L^T with reciprocals in d.
double ldlt_element(const Numbers& L, const Numbers& d, int stride, int i, int j)
{
    double sum = 0;
    for (int k = 0; k <= std::min(i, j); ++k) {
        const double a = k == i ? 1 : double(L[std::size_t(i * stride + k)]);
        const double b = k == j ? 1 : double(L[std::size_t(j * stride + k)]);
        sum += a * b / double(d[std::size_t(k)]);
    }
    return sum;
}

Real tolerance(int n) { return 40 * Real(n) * Real(n) * kEpsilon; }

TEST(Dense, dot_of_every_length)
{
    RandomNumbers random(1);
    for (int n = 0; n < 70; ++n) {
        const Numbers a = random_numbers(random, std::size_t(n) + 1),
                      b = random_numbers(random, std::size_t(n) + 1);
        double expected = 0;
        for (int i = 0; i < n; ++i) expected += double(a[std::size_t(i)]) * double(b[std::size_t(i)]);
        EXPECT_NEAR(dot(a.data(), b.data(), n), expected, tolerance(n) + kEpsilon);
    }
}

TEST(Dense, three_products_agree_with_the_definition_and_leave_padding_alone)
{
    RandomNumbers random(2);
    for (int round = 0; round < 200; ++round) {
        const int p = 1 + random.below(9), q = 1 + random.below(9), r = 1 + random.below(9);
        const Numbers B = random_numbers(random, padded_size(p, q)),
                      Bt = random_numbers(random, padded_size(q, p));
        const Numbers C = random_numbers(random, padded_size(q, r)),
                      Ct = random_numbers(random, padded_size(r, q));
        Numbers A0(padded_size(p, r), 9), A1 = A0, A2 = A0;
        multiply(A0.data(), B.data(), C.data(), p, q, r);
        multiply_transposed_left(A1.data(), Bt.data(), C.data(), p, q, r);
        multiply_transposed_right(A2.data(), B.data(), Ct.data(), p, q, r);
        for (int i = 0; i < p; ++i) {
            for (int j = 0; j < r; ++j) {
                double e0 = 0, e1 = 0, e2 = 0;
                for (int k = 0; k < q; ++k) {
                    e0 +=
                        double(row_of(B.data(), i, padded(q))[k]) * double(row_of(C.data(), k, padded(r))[j]);
                    e1 += double(row_of(Bt.data(), k, padded(p))[i]) *
                          double(row_of(C.data(), k, padded(r))[j]);
                    e2 += double(row_of(B.data(), i, padded(q))[k]) *
                          double(row_of(Ct.data(), j, padded(q))[k]);
                }
                EXPECT_NEAR(row_of(A0.data(), i, padded(r))[j], e0, tolerance(q));
                EXPECT_NEAR(row_of(A1.data(), i, padded(r))[j], e1, tolerance(q));
                EXPECT_NEAR(row_of(A2.data(), i, padded(r))[j], e2, tolerance(q));
            }
            for (int j = r; j < padded(r); ++j) EXPECT_EQ(row_of(A0.data(), i, padded(r))[j], 9);
        }
    }
}

TEST(Dense, removing_a_row_and_column_keeps_the_rest_in_order)
{
    for (int n = 1; n < 12; ++n)
        for (int r = 0; r < n; ++r) {
            const int stride = n + 3;
            Numbers A(std::size_t(n * stride));
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < stride; ++j) A[std::size_t(i * stride + j)] = Real(100 * i + j);
            remove_row_and_column(A.data(), n, stride, r);
            for (int i = 0; i < n - 1; ++i)
                for (int j = 0; j < n - 1; ++j)
                    EXPECT_EQ(A[std::size_t(i * stride + j)],
                              100 * (i < r ? i : i + 1) + (j < r ? j : j + 1));
        }
}

class Sizes : public testing::TestWithParam<int> {};

TEST_P(Sizes, cholesky_factor_multiplies_back_and_solves)
{
    const int n = GetParam(), stride = padded(n);
    RandomNumbers random{std::uint64_t(n)};
    const Numbers A = random.positive_definite(n, stride);
    Numbers L = A, inverse(A.size(), 5);
    ASSERT_TRUE(factor_cholesky(L.data(), n));
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
            double sum = 0;
            for (int k = 0; k <= j; ++k)
                sum += double(L[std::size_t(i * stride + k)]) * double(L[std::size_t(j * stride + k)]);
            EXPECT_NEAR(sum, A[std::size_t(i * stride + j)], tolerance(n));
        }
    const Numbers truth = random_numbers(random, std::size_t(stride));
    Numbers b(std::size_t(n), 0);
    for (int i = 0; i < n; ++i) b[std::size_t(i)] = dot(row_of(A.data(), i, stride), truth.data(), n);
    solve_cholesky(L.data(), b.data(), n);
    for (int i = 0; i < n; ++i) EXPECT_NEAR(b[std::size_t(i)], truth[std::size_t(i)], tolerance(n));
    invert_from_cholesky(L.data(), inverse.data(), n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Real element = dot(row_of(A.data(), i, stride), row_of(inverse.data(), j, stride), n);
            EXPECT_NEAR(element, i == j ? 1 : 0, tolerance(n));
            EXPECT_EQ(inverse[std::size_t(i * stride + j)], inverse[std::size_t(j * stride + i)]);
        }
        for (int j = n; j < stride; ++j) EXPECT_EQ(inverse[std::size_t(i * stride + j)], 0);
    }
}

TEST_P(Sizes, ldlt_factor_multiplies_back_and_solves_at_any_stride)
{
    const int n = GetParam();
    for (int stride : {n, n + 1, padded(n) + 4}) {
        RandomNumbers random{std::uint64_t(n + 1000 * stride)};
        const Numbers A = random.positive_definite(n, stride);
        Numbers L = A, d(std::size_t(n), 0);
        factor_ldlt(L.data(), d.data(), n, stride);
        for (int i = 0; i < n; ++i) {
            EXPECT_EQ(L[std::size_t(i * stride + i)], A[std::size_t(i * stride + i)])
                << "diagonal is left alone";
            for (int j = 0; j <= i; ++j)
                EXPECT_NEAR(ldlt_element(L, d, stride, i, j), A[std::size_t(i * stride + j)], tolerance(n));
        }
        const Numbers truth = random_numbers(random, std::size_t(n));
        Numbers b(std::size_t(n), 0);
        for (int i = 0; i < n; ++i) b[std::size_t(i)] = dot(row_of(A.data(), i, stride), truth.data(), n);
        solve_ldlt(L.data(), d.data(), b.data(), n, stride);
        for (int i = 0; i < n; ++i) EXPECT_NEAR(b[std::size_t(i)], truth[std::size_t(i)], tolerance(n));
    }
}

TEST_P(Sizes, removal_equals_factoring_the_smaller_matrix)
{
    const int n = GetParam(), stride = padded(n) + 1;
    if (n < 2 || n > 60) return;
    RandomNumbers random{std::uint64_t(n) * 7};
    const Numbers A = random.positive_definite(n, stride);
    for (int r = 0; r < n; ++r) {
        Numbers L = A, d(std::size_t(n), 0), smaller = A, work(2 * std::size_t(n));
        factor_ldlt(L.data(), d.data(), n, stride);
        remove_from_ldlt(L.data(), d.data(), n, r, stride, work.data());
        remove_row_and_column(smaller.data(), n, stride, r);
        for (int i = 0; i < n - 1; ++i)
            for (int j = 0; j <= i; ++j)
                EXPECT_NEAR(ldlt_element(L, d, stride, i, j), smaller[std::size_t(i * stride + j)],
                            tolerance(n));
    }
}

TEST_P(Sizes, top_left_update_gives_the_trailing_factors_of_the_changed_matrix)
{
    const int n = GetParam(), stride = padded(n);
    if (n < 2 || n > 60) return;
    RandomNumbers random{std::uint64_t(n) * 11};
    const Numbers A = random.positive_definite(n, stride);
    Numbers a(std::size_t(n), 0), changed = A, L = A, d(std::size_t(n), 0), d2 = d, work(3 * std::size_t(n));
    for (Real& x : a) x = random.in(Real(-0.05), Real(0.05));
    for (int i = 0; i < n; ++i) {
        changed[std::size_t(i * stride)] += a[std::size_t(i)];
        if (i) changed[std::size_t(i)] += a[std::size_t(i)];
    }
    factor_ldlt(L.data(), d.data(), n, stride);
    const Numbers before = L;
    factor_ldlt(changed.data(), d2.data(), n, stride);
    add_to_top_left(L.data(), d.data(), a.data(), n, stride, work.data());
    for (int i = 1; i < n; ++i) {
        EXPECT_NEAR(d[std::size_t(i)] / d2[std::size_t(i)], 1, tolerance(n));
        EXPECT_EQ(L[std::size_t(i * stride)], before[std::size_t(i * stride)]) << "column 0 keeps its value";
        for (int j = 1; j < i; ++j)
            EXPECT_NEAR(L[std::size_t(i * stride + j)], changed[std::size_t(i * stride + j)], tolerance(n));
    }
}

INSTANTIATE_TEST_SUITE_P(FromOneToLarge, Sizes,
                         testing::Values(1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 33, 60, 150));

TEST(Cholesky, says_no_to_an_indefinite_matrix)
{
    Real semidefinite[8] = {4, 0, 0, 0, 2, 1, 0, 0};
    EXPECT_FALSE(factor_cholesky(semidefinite, 2));
    Real indefinite[8] = {1, 0, 0, 0, 2, 1, 0, 0};
    EXPECT_FALSE(factor_cholesky(indefinite, 2));
    Real nan[1] = {std::numeric_limits<Real>::quiet_NaN()};
    EXPECT_FALSE(factor_cholesky(nan, 1));
}

TEST(Ldlt, indefinite_matrices_factor_too_when_no_pivot_vanishes)
{
    Numbers L = {2, 0, 0, 0, 4, 3, 0, 0}, d(2);
    factor_ldlt(L.data(), d.data(), 2, 4);
    EXPECT_EQ(d[0], Real(0.5));
    EXPECT_EQ(d[1], Real(-0.2));
    EXPECT_EQ(L[4], 2);
    Real zero[1] = {0}, reciprocal[1];
    factor_ldlt(zero, reciprocal, 1, 1);
    EXPECT_EQ(reciprocal[0], kInf);
}

TEST(Scratch, allocates_only_for_large_sizes)
{
    const std::size_t before = allocation_count();
    {
        Scratch small(100);
        ASSERT_TRUE(small.ok());
        EXPECT_EQ(allocation_count(), before);
        Scratch large(100000);
        ASSERT_TRUE(large.ok());
        large.data()[99999] = 1;
        EXPECT_EQ(allocation_count(), before + 1);
    }
    memory_hooks().alloc = [](std::size_t) -> void* { return nullptr; };
    EXPECT_FALSE(Scratch(100000).ok());
    memory_hooks() = {};
}

}  // namespace
}  // namespace epode
