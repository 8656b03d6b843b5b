// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The matrix functions as clients call them: layouts, return values, refusals, exhausted memory. Their
// mathematics at every size is tested in unit/math.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "message_recorder.h"

namespace {

TEST(MatrixApi, makes_vectors)
{
    dReal a[5] = {1, 2, 3, 4, 5};
    const dReal d[4] = {2, 3, 4, 5};
    EXPECT_EQ(dDot(a, d, 4), 40);
    dScaleVector(a, d, 4);
    EXPECT_EQ(a[3], 20);
    EXPECT_EQ(a[4], 5);
    dSetValue(a, 2, 7);
    dSetZero(a + 2, 2);
    EXPECT_EQ(a[1], 7);
    EXPECT_EQ(a[2] + a[3], 0);
    EXPECT_EQ(a[4], 5);
}

TEST(MatrixApi, products_use_padded_rows)
{
    // B is 2 x 3, C is 3 x 2; rows of 4.
    const dReal B[8] = {1, 2, 3, 99, 4, 5, 6, 99}, C[12] = {1, 2, 99, 99, 3, 4, 99, 99, 5, 6, 99, 99};
    dReal A[8];
    dMultiply0(A, B, C, 2, 3, 2);
    EXPECT_EQ(A[0], 22);
    EXPECT_EQ(A[1], 28);
    EXPECT_EQ(A[4], 49);
    EXPECT_EQ(A[5], 64);
    dMultiply1(A, C, C, 2, 3, 2);  // C^T C
    EXPECT_EQ(A[0], 35);
    EXPECT_EQ(A[1], 44);
    EXPECT_EQ(A[5], 56);
    dMultiply2(A, B, B, 2, 3, 2);  // B B^T
    EXPECT_EQ(A[0], 14);
    EXPECT_EQ(A[1], 32);
    EXPECT_EQ(A[5], 77);
    dReal column[3];  // one column: rows are not padded
    const dReal x[3] = {1, 1, 1};
    dMultiply0(column, B, x, 2, 3, 1);
    EXPECT_EQ(column[0], 6);
    EXPECT_EQ(column[1], 15);
}

TEST(MatrixApi, cholesky_family)
{
    dReal A[8] = {4, 77, 0, 0, 2, 10, 0, 0};
    EXPECT_EQ(dIsPositiveDefinite(A, 2), 1);
    dReal inverse[8];
    EXPECT_EQ(dInvertPDMatrix(A, inverse, 2), 1);
    EXPECT_NEAR(inverse[0], 10.0 / 36, 1e-6);
    EXPECT_NEAR(inverse[1], -2.0 / 36, 1e-6);
    EXPECT_NEAR(inverse[5], 4.0 / 36, 1e-6);
    EXPECT_EQ(dFactorCholesky(A, 2), 1);
    EXPECT_EQ(A[0], 2);
    EXPECT_EQ(A[1], 77) << "the upper triangle is neither read nor written";
    EXPECT_EQ(A[4], 1);
    EXPECT_EQ(A[5], 3);
    dReal b[2] = {8, 22};
    dSolveCholesky(A, b, 2);
    EXPECT_NEAR(b[0], 1, 1e-6);
    EXPECT_NEAR(b[1], 2, 1e-6);
    const dReal indefinite[8] = {1, 0, 0, 0, 2, 1, 0, 0};
    dReal untouched[8] = {5};
    EXPECT_EQ(dIsPositiveDefinite(indefinite, 2), 0);
    EXPECT_EQ(dInvertPDMatrix(indefinite, untouched, 2), 0);
    EXPECT_EQ(untouched[0], 5);
}

TEST(MatrixApi, ldlt_family_with_reciprocal_pivots)
{
    dReal A[9] = {4, 0, 0, 8, 19, 0, 4, 11, 12};
    dReal* rows[3] = {A, A + 3, A + 6};
    dReal L[9], d[3];
    for (int i = 0; i < 9; ++i) L[i] = A[i];
    dFactorLDLT(L, d, 3, 3);
    EXPECT_EQ(L[3], 2);
    EXPECT_EQ(L[6], 1);
    EXPECT_EQ(L[7], 1);
    EXPECT_EQ(d[0], dReal(0.25));
    EXPECT_EQ(d[1], dReal(1) / 3);
    EXPECT_EQ(d[2], dReal(0.2));
    dReal b[3] = {1, 4, 9};
    dSolveL1(L, b, 3, 3);
    EXPECT_EQ(b[1], 2);
    EXPECT_EQ(b[2], 6);
    dSolveL1T(L, b, 3, 3);
    EXPECT_EQ(b[0], 3);
    EXPECT_EQ(b[1], -4);
    dReal x[3] = {16, 38, 27};
    dSolveLDLT(L, d, x, 3, 3);
    for (dReal xi : x) EXPECT_NEAR(xi, 1, 1e-5);
    const int p[3] = {0, 1, 2};
    dLDLTRemove(rows, p, L, d, 3, 3, 0, 3);  // leaves [19 11; 11 12]
    EXPECT_NEAR(1 / d[0], 19, 1e-4);
    EXPECT_NEAR(L[3], 11.0 / 19, 1e-6);
    EXPECT_NEAR(1 / d[1], 12 - 121.0 / 19, 1e-4);
}

TEST(MatrixApi, bad_arguments_are_refused_once)
{
    MessageRecorder messages;
    dReal a[16] = {4, 0, 0, 0, 0, 4}, d[4] = {1, 1, 1, 1};
    dReal* rows[2] = {a, a + 4};
    const int good[2] = {0, 1}, wild[2] = {0, 5};
    const std::vector<std::pair<std::string, std::function<void()>>> calls = {
        {"dSetZero", [&] { dSetZero(nullptr, 1); }},
        {"dSetZero", [&] { dSetZero(a, -1); }},
        {"dSetValue", [&] { dSetValue(a, -1, 1); }},
        {"dDot", [&] { dDot(a, nullptr, 1); }},
        {"dMultiply0", [&] { dMultiply0(a, a, a, 1, 0, 1); }},
        {"dMultiply1", [&] { dMultiply1(a, nullptr, a, 1, 1, 1); }},
        {"dMultiply2", [&] { dMultiply2(a, a, a, -1, 1, 1); }},
        {"dFactorCholesky", [&] { dFactorCholesky(a, 0); }},
        {"dSolveCholesky", [&] { dSolveCholesky(a, nullptr, 1); }},
        {"dInvertPDMatrix", [&] { dInvertPDMatrix(a, nullptr, 1); }},
        {"dIsPositiveDefinite", [&] { dIsPositiveDefinite(nullptr, 1); }},
        {"dFactorLDLT", [&] { dFactorLDLT(a, d, 2, 1); }},
        {"dFactorLDLT", [&] { dFactorLDLT(a, nullptr, 1, 1); }},
        {"dSolveL1", [&] { dSolveL1(a, d, 0, 1); }},
        {"dSolveL1T", [&] { dSolveL1T(a, d, 2, 1); }},
        {"dScaleVector", [&] { dScaleVector(d, nullptr, 1); }},
        {"dSolveLDLT", [&] { dSolveLDLT(a, nullptr, d, 1, 1); }},
        {"dLDLTAddTL", [&] { dLDLTAddTL(a, d, d, 0, 1); }},
        {"dLDLTAddTL", [&] { dLDLTAddTL(a, d, d, 2, 1); }},
        {"dLDLTRemove", [&] { dLDLTRemove(rows, good, a, d, 2, 2, 2, 4); }},
        {"dLDLTRemove", [&] { dLDLTRemove(rows, wild, a, d, 2, 2, 0, 4); }},
        {"dLDLTRemove", [&] { dLDLTRemove(rows, good, a, d, 2, 2, 0, 1); }},
        {"dRemoveRowCol", [&] { dRemoveRowCol(a, 2, 4, 2); }},
        {"dRemoveRowCol", [&] { dRemoveRowCol(a, 2, 1, 0); }},
    };
    for (const auto& [name, call] : calls) {
        call();
        EXPECT_EQ(messages.take(), "2: Bad argument(s) in " + name + "()");
        EXPECT_EQ(a[0], 4) << name;
        EXPECT_EQ(a[5], 4) << name;
        EXPECT_EQ(d[0], 1) << name;
    }
}

TEST(MatrixApi, exhausted_memory_is_an_answer_and_not_a_crash)
{
    MessageRecorder messages;
    constexpr int n = 200;  // beyond the stack buffers
    std::vector<dReal> A(n * n), inverse(n * n, 3);
    for (int i = 0; i < n; ++i) A[std::size_t(i * n + i)] = 2;
    dSetAllocHandler([](dsizeint) -> void* { return nullptr; });
    EXPECT_EQ(dInvertPDMatrix(A.data(), inverse.data(), n), 0);
    EXPECT_EQ(dIsPositiveDefinite(A.data(), n), 0);
    dSetAllocHandler(nullptr);
    EXPECT_EQ(messages.take(),
              "2: out of memory in dInvertPDMatrix()|2: out of memory in dIsPositiveDefinite()");
    EXPECT_EQ(inverse[0], 3);
    EXPECT_EQ(dInvertPDMatrix(A.data(), inverse.data(), n), 1);
    EXPECT_NEAR(inverse[0], 0.5, 1e-6);
}

// ---- properties, on random matrices with eigenvalues from 1 on ----

constexpr double kRounding = sizeof(dReal) == 8 ? 1e-13 : 1e-5;

struct Definite {
    Definite(int size, unsigned long seed) : n(size), skip(dPAD(size)), a(std::size_t(n * skip))
    {
        dRandSetSeed(seed);
        std::vector<dReal> g(a.size());
        dMakeRandomMatrix(g.data(), n, n, 1);
        dMultiply2(a.data(), g.data(), g.data(), n, n, n);
        for (int i = 0; i < n; ++i) at(i, i) += dReal(n);
    }
    dReal& at(int i, int j) { return a[std::size_t(i * skip + j)]; }
    int n, skip;
    std::vector<dReal> a;
};

TEST(MatrixProperties, solutions_leave_a_residual_of_rounding_at_every_size_up_to_100)
{
    for (int n = 1; n <= 100; ++n) {
        Definite m(n, unsigned(n));
        std::vector<dReal> b(std::size_t(n), 0), cholesky = m.a, ldlt = m.a, d(b), inverse(m.a.size());
        dMakeRandomVector(b.data(), n, 1);
        std::vector<dReal> x = b, y = b, left(b);
        ASSERT_EQ(dFactorCholesky(cholesky.data(), n), 1);
        dSolveCholesky(cholesky.data(), x.data(), n);
        dFactorLDLT(ldlt.data(), d.data(), n, m.skip);
        dSolveLDLT(ldlt.data(), d.data(), y.data(), n, m.skip);
        ASSERT_EQ(dInvertPDMatrix(m.a.data(), inverse.data(), n), 1);
        for (const std::vector<dReal>* solution : {&x, &y}) {
            dMultiply0(left.data(), m.a.data(), solution->data(), n, n, 1);
            EXPECT_LE(dMaxDifference(left.data(), b.data(), n, 1), kRounding * n) << n;
        }
        std::vector<dReal> unit(m.a.size());
        dMultiply0(unit.data(), m.a.data(), inverse.data(), n, n, n);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                ASSERT_NEAR(unit[std::size_t(i * m.skip + j)], i == j ? 1 : 0, kRounding * n) << n;
    }
}

// A chain of removals keeps the factors of what is left: 60 rows down to 1, in any order.
TEST(MatrixProperties, removals_in_a_row_equal_refactorisation)
{
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Definite m(60, seed);
        std::vector<dReal*> rows;
        std::vector<int> left;
        for (int i = 0; i < m.n; ++i) rows.push_back(&m.at(i, 0)), left.push_back(m.n - 1 - i);
        std::vector<dReal> L(m.a.size()), d(std::size_t(m.n));
        const auto gather = [&](std::vector<dReal>& to) {
            for (std::size_t i = 0; i < left.size(); ++i)
                for (std::size_t j = 0; j <= i; ++j)
                    to[i * std::size_t(m.skip) + j] =
                        m.at(std::max(left[i], left[j]), std::min(left[i], left[j]));
        };
        gather(L);
        dFactorLDLT(L.data(), d.data(), m.n, m.skip);
        while (left.size() > 1) {
            const int n2 = int(left.size()), r = dRandInt(n2);
            dLDLTRemove(rows.data(), left.data(), L.data(), d.data(), m.n, n2, r, m.skip);
            left.erase(left.begin() + r);
            std::vector<dReal> fresh(L.size()), fresh_d(d.size());
            gather(fresh);
            dFactorLDLT(fresh.data(), fresh_d.data(), n2 - 1, m.skip);
            for (int i = 0; i < n2 - 1; ++i) {
                ASSERT_NEAR(d[std::size_t(i)] / fresh_d[std::size_t(i)], 1, 100 * kRounding) << n2;
                for (int j = 0; j < i; ++j)
                    ASSERT_NEAR(L[std::size_t(i * m.skip + j)], fresh[std::size_t(i * m.skip + j)],
                                100 * kRounding)
                        << n2;
            }
        }
    }
}

// A row and column added by dLDLTAddTL and taken out by dLDLTRemove leave what was there without row 0.
TEST(MatrixProperties, an_addition_at_the_top_left_is_a_change_of_the_first_row)
{
    for (int n = 2; n <= 60; n += 3) {
        Definite m(n, 7u * unsigned(n));
        std::vector<dReal> L = m.a, d(std::size_t(n), 0), a = d, changed = m.a, d2 = d;
        dMakeRandomVector(a.data(), n, dReal(0.3));
        dFactorLDLT(L.data(), d.data(), n, m.skip);
        dLDLTAddTL(L.data(), d.data(), a.data(), n, m.skip);
        for (int i = 0; i < n; ++i) changed[std::size_t(i * m.skip)] += a[std::size_t(i)];
        dFactorLDLT(changed.data(), d2.data(), n, m.skip);
        for (int i = 1; i < n; ++i) {
            EXPECT_NEAR(d[std::size_t(i)] / d2[std::size_t(i)], 1, 100 * kRounding) << n;
            for (int j = 1; j < i; ++j)
                EXPECT_NEAR(L[std::size_t(i * m.skip + j)], changed[std::size_t(i * m.skip + j)],
                            100 * kRounding)
                    << n;
        }
    }
}

}  // namespace
