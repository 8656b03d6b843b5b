// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The cooperative functions compute what the plain ones compute, to the last bit, on any number of threads
// and for sizes on both sides of every block; the answer solves the equations; containers keep their word.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "../../effort.h"
#include "message_recorder.h"

namespace {

using epode::tests::effort;
using Reals = std::vector<dReal>;

// A cooperative with `threads` threads of a pool, or 0: self-threaded, or -1: none given.
struct Crew {
    explicit Crew(int threads)
    {
        dInitODE2(0);
        if (threads < 0) {
            cooperative = dCooperativeCreate(nullptr, nullptr);
            return;
        }
        impl = threads ? dThreadingAllocateMultiThreadedImplementation()
                       : dThreadingAllocateSelfThreadedImplementation();
        if (threads) {
            pool = dThreadingAllocateThreadPool(unsigned(threads), 0, dAllocateFlagBasicData, nullptr);
            dThreadingThreadPoolServeMultiThreadedImplementation(pool, impl);
        }
        cooperative = dCooperativeCreate(dThreadingImplementationGetFunctions(impl), impl);
    }
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;
    ~Crew()
    {
        dCooperativeDestroy(cooperative);
        if (impl) dThreadingImplementationShutdownProcessing(impl);
        dThreadingFreeThreadPool(pool);
        dThreadingFreeImplementation(impl);
        dCloseODE();
    }

    // A container for `rows` and `elements`.
    dResourceContainerID acquire(unsigned rows, unsigned elements = 0) const
    {
        const dResourceRequirementsID r = dResourceRequirementsCreate(cooperative);
        dEstimateCooperativelyFactorLDLTResourceRequirements(r, 0, rows);
        dEstimateCooperativelyScaleVectorResourceRequirements(r, 0, elements);
        const dResourceContainerID c = dResourceContainerAcquire(r);
        dResourceRequirementsDestroy(r);
        return c;
    }

    dThreadingImplementationID impl = nullptr;
    dThreadingThreadPoolID pool = nullptr;
    dCooperativeID cooperative = nullptr;
};

struct Numbers {
    unsigned state = 12345;
    dReal next()
    {
        state = state * 1664525u + 1013904223u;
        return dReal(state >> 8) / dReal(1 << 23) - 1;
    }
    Reals take(std::size_t n)
    {
        Reals all(n);
        for (dReal& x : all) x = next();
        return all;
    }
};

// Symmetric and diagonally dominant, numbers between the rows included.
Reals matrix(int n, int skip, unsigned seed)
{
    Numbers numbers{seed};
    Reals A = numbers.take(std::size_t(n) * std::size_t(skip));
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < i; ++j) A[std::size_t(i * skip + j)] = A[std::size_t(j * skip + i)];
        A[std::size_t(i * skip + i)] = dReal(n) + numbers.next();
    }
    return A;
}

constexpr int kCrews[] = {-1, 0, 1, 2, 4};

TEST(Cooperative, factors_have_the_bits_of_the_plain_ones_on_any_number_of_threads)
{
    for (const int n : {1, 2, 3, 5, 64, 127, 128, 129, 201, effort(500)}) {
        const int skip = n + n % 3;
        const Reals A = matrix(n, skip, unsigned(n)), none(std::size_t(n), 0);
        Reals L = A, d = none;
        dFactorLDLT(L.data(), d.data(), n, skip);
        for (const int threads : kCrews) {
            const Crew crew(threads);
            const dResourceContainerID c = crew.acquire(unsigned(n));
            ASSERT_NE(c, nullptr);
            Reals L2 = A, d2 = none;
            dCooperativelyFactorLDLT(c, 0, L2.data(), d2.data(), unsigned(n), unsigned(skip));
            EXPECT_EQ(L2, L) << n << ' ' << threads;
            EXPECT_EQ(d2, d) << n << ' ' << threads;
            dResourceContainerDestroy(c);
        }
    }
}

TEST(Cooperative, solutions_have_the_bits_of_the_plain_ones_on_any_number_of_threads)
{
    for (const int n : {1, 2, 3, 5, 64, 201, 1023, 1024, 1089}) {
        const int skip = n + n % 3;
        Numbers numbers;
        Reals L = numbers.take(std::size_t(n) * std::size_t(skip));
        for (dReal& x : L) x /= dReal(n);
        const Reals b = numbers.take(std::size_t(n)), d = numbers.take(std::size_t(n));
        Reals x = b, y = b, z = b, s = b;
        dSolveLDLT(L.data(), d.data(), x.data(), n, skip);
        dSolveL1(L.data(), y.data(), n, skip);
        dSolveL1T(L.data(), z.data(), n, skip);
        dScaleVector(s.data(), d.data(), n);
        for (const int threads : kCrews) {
            const Crew crew(threads);
            const dResourceContainerID c = crew.acquire(unsigned(n));
            Reals x2 = b, y2 = b, z2 = b, s2 = b;
            dCooperativelySolveLDLT(c, 0, L.data(), d.data(), x2.data(), unsigned(n), unsigned(skip));
            EXPECT_EQ(x2, x) << n << ' ' << threads;
            dCooperativelySolveL1Straight(c, 0, L.data(), y2.data(), unsigned(n), unsigned(skip));
            EXPECT_EQ(y2, y) << n << ' ' << threads;
            dCooperativelySolveL1Transposed(c, 0, L.data(), z2.data(), unsigned(n), unsigned(skip));
            EXPECT_EQ(z2, z) << n << ' ' << threads;
            dCooperativelyScaleVector(c, 0, s2.data(), d.data(), unsigned(n));
            EXPECT_EQ(s2, s) << n << ' ' << threads;
            dResourceContainerDestroy(c);
        }
    }
}

TEST(Cooperative, long_vectors_are_scaled_alike)
{
    constexpr int kLong = 300001;
    Numbers numbers;
    const Reals a = numbers.take(kLong), d = numbers.take(kLong);
    Reals expected = a;
    dScaleVector(expected.data(), d.data(), kLong);
    for (const int threads : kCrews) {
        const Crew crew(threads);
        const dResourceContainerID c = crew.acquire(0, kLong);
        Reals got = a;
        dCooperativelyScaleVector(c, 0, got.data(), d.data(), kLong);
        EXPECT_TRUE(got == expected) << threads;
        dResourceContainerDestroy(c);
    }
}

TEST(Cooperative, factors_and_solution_satisfy_the_equations)
{
    constexpr int n = 300, skip = 301;
    const Crew crew(3);
    const dResourceContainerID c = crew.acquire(n);
    const Reals A = matrix(n, skip, 7);
    Numbers numbers;
    const Reals b = numbers.take(n);
    Reals L = A, d(n), x = b;
    dCooperativelyFactorLDLT(c, 2, L.data(), d.data(), n, skip);
    dCooperativelySolveLDLT(c, 3, L.data(), d.data(), x.data(), n, skip);
    double worst = 0;
    for (int i = 0; i < n; ++i) {
        double sum = 0;
        for (int j = 0; j < n; ++j) sum += double(A[std::size_t(i * skip + j)]) * double(x[std::size_t(j)]);
        worst = std::max(worst, std::abs(sum - double(b[std::size_t(i)])));
    }
    EXPECT_LT(worst, sizeof(dReal) == 8 ? 1e-13 : 1e-4);
    // The upper triangle and what lies between the rows stay.
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < skip; ++j)
            ASSERT_EQ(L[std::size_t(i * skip + j)], A[std::size_t(i * skip + j)]);
    dResourceContainerDestroy(c);
}

TEST(Cooperative, a_container_serves_what_was_merged_and_nothing_larger)
{
    MessageRecorder messages;
    const Crew crew(2), other(2);
    const dResourceRequirementsID a = dResourceRequirementsCreate(crew.cooperative);
    const dResourceRequirementsID b = dResourceRequirementsCreate(crew.cooperative);
    const dResourceRequirementsID foreign = dResourceRequirementsCreate(other.cooperative);
    dEstimateCooperativelyFactorLDLTResourceRequirements(a, 1, 8);
    const dResourceRequirementsID before = dResourceRequirementsClone(a);
    dEstimateCooperativelySolveLDLTResourceRequirements(b, 2, 20);
    dEstimateCooperativelyScaleVectorResourceRequirements(b, 2, 30);
    dResourceRequirementsMergeIn(a, b);
    EXPECT_EQ(messages.take(), "");
    dResourceRequirementsMergeIn(a, foreign);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dResourceRequirementsMergeIn()");
    const dResourceContainerID large = dResourceContainerAcquire(a),
                               small = dResourceContainerAcquire(before);
    for (const dResourceRequirementsID r : {a, b, before, foreign}) dResourceRequirementsDestroy(r);

    const Reals A = matrix(21, 24, 1);
    Reals L = A, d(21), v(31, 2);
    dCooperativelyFactorLDLT(large, 0, L.data(), d.data(), 20, 24);
    dCooperativelySolveL1Straight(large, 0, L.data(), v.data(), 20, 24);
    dCooperativelyScaleVector(large, 0, v.data(), v.data(), 30);
    EXPECT_EQ(messages.take(), "");
    const Reals factored = L, vector = v;
    dCooperativelyFactorLDLT(large, 0, L.data(), d.data(), 21, 24);
    dCooperativelyFactorLDLT(small, 0, L.data(), d.data(), 9, 24);
    dCooperativelySolveLDLT(small, 0, L.data(), d.data(), v.data(), 9, 24);
    dCooperativelySolveL1Straight(small, 0, L.data(), v.data(), 9, 24);
    dCooperativelySolveL1Transposed(small, 0, L.data(), v.data(), 9, 24);
    dCooperativelyScaleVector(small, 0, v.data(), d.data(), 9);
    EXPECT_EQ(
        messages.take(),
        "2: Bad argument(s) in dCooperativelyFactorLDLT()|2: Bad argument(s) in dCooperativelyFactorLDLT()|"
        "2: Bad argument(s) in dCooperativelySolveLDLT()|"
        "2: Bad argument(s) in dCooperativelySolveL1Straight()|"
        "2: Bad argument(s) in dCooperativelySolveL1Transposed()|"
        "2: Bad argument(s) in dCooperativelyScaleVector()");
    EXPECT_EQ(L, factored);
    EXPECT_EQ(v, vector);
    dResourceContainerDestroy(large);
    dResourceContainerDestroy(small);
    dCooperativelyScaleVector(small, 0, v.data(), d.data(), 3);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dCooperativelyScaleVector()");
}

TEST(Cooperative, bad_arguments_are_refused_and_the_order_of_destruction_is_free)
{
    MessageRecorder messages;
    dCooperativeDestroy(nullptr);
    dResourceRequirementsDestroy(nullptr);
    dResourceContainerDestroy(nullptr);
    EXPECT_EQ(messages.take(), "");
    const dThreadingImplementationID impl = dThreadingAllocateSelfThreadedImplementation();
    dThreadingFunctionsInfo table = *dThreadingImplementationGetFunctions(impl);
    EXPECT_EQ(dCooperativeCreate(&table, nullptr), nullptr);
    EXPECT_EQ(dCooperativeCreate(nullptr, impl), nullptr);
    table.wait_call = nullptr;
    EXPECT_EQ(dCooperativeCreate(&table, impl), nullptr);
    EXPECT_EQ(dResourceRequirementsCreate(nullptr), nullptr);
    EXPECT_EQ(dResourceRequirementsClone(nullptr), nullptr);
    EXPECT_EQ(dResourceContainerAcquire(nullptr), nullptr);
    dResourceRequirementsMergeIn(nullptr, nullptr);
    dEstimateCooperativelyFactorLDLTResourceRequirements(nullptr, 0, 1);
    dCooperativelyFactorLDLT(nullptr, 0, nullptr, nullptr, 0, 0);
    const std::string all = messages.take();
    EXPECT_EQ(std::count(all.begin(), all.end(), '|') + 1, 9) << all;

    const dCooperativeID cooperative = dCooperativeCreate(dThreadingImplementationGetFunctions(impl), impl);
    const dResourceRequirementsID r = dResourceRequirementsCreate(cooperative);
    dCooperativeDestroy(cooperative);
    EXPECT_EQ(dResourceRequirementsCreate(cooperative), nullptr);
    dEstimateCooperativelySolveL1StraightResourceRequirements(r, 4, 10);
    const dResourceContainerID c = dResourceContainerAcquire(r);
    dResourceRequirementsDestroy(r);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dResourceRequirementsCreate()");
    Reals L = matrix(10, 12, 3), b(10, 1);
    dCooperativelySolveL1Straight(c, 0, nullptr, b.data(), 10, 12);
    dCooperativelySolveL1Straight(c, 0, L.data(), nullptr, 10, 12);
    dCooperativelySolveL1Straight(c, 0, L.data(), b.data(), 10, 9);
    dCooperativelySolveL1Straight(c, 0, L.data(), b.data(), 10, ~0u);
    EXPECT_EQ(b, Reals(10, 1));
    const std::string refused = messages.take();
    EXPECT_EQ(std::count(refused.begin(), refused.end(), '|') + 1, 4) << refused;
    dCooperativelySolveL1Straight(c, 0, nullptr, nullptr, 0, 0);
    dResourceContainerDestroy(c);
    dThreadingFreeImplementation(impl);
    EXPECT_EQ(messages.take(), "");
}

TEST(Cooperative, threads_that_are_released_meanwhile_do_not_matter)
{
    constexpr int n = 200;
    const Reals A = matrix(n, n, 5);
    Reals L = A, d(n);
    dFactorLDLT(L.data(), d.data(), n, n);
    Crew crew(3);
    const dResourceContainerID c = crew.acquire(n);
    dThreadingImplementationShutdownProcessing(crew.impl);
    Reals L2 = A, d2(n);
    dCooperativelyFactorLDLT(c, 0, L2.data(), d2.data(), n, n);
    EXPECT_EQ(L2, L);
    dResourceContainerDestroy(c);
}

}  // namespace
