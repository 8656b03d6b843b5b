// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A copy's bits depend neither on its neighbours and its place, nor on threads; tests/batch/kernels.sh runs the golden hashes with
// every instruction set.
#include "golden/golden.h"
#include "models.h"

namespace epode::tests {
namespace {

template <typename T>
std::vector<T> state_of(Copies<T>& copies, int copy)
{
    auto out = copies.read(dBatchPositions, copy, 1);
    const auto v = copies.read(dBatchVelocities, copy, 1);
    out.insert(out.end(), v.begin(), v.end());
    return out;
}

// Copy i of many falls, bumps about and is driven in a way of its own.
template <typename T>
void disturb(Copies<T>& copies, dRobotModelID model, int copy, unsigned seed)
{
    Dice dice(seed);
    auto q = any_positions(model, dice), v = dice.many(14, -1, 1), c = dice.many(5, -1, 1);
    q[2] = dice.between(0.5, 0.7);
    copies.write_one(dBatchPositions, copy, {q.begin(), q.end()}),
        copies.write_one(dBatchVelocities, copy, {v.begin(), v.end()});
    copies.write_one(dBatchControls, copy, {c.begin(), c.end()});
}

template <typename T>
void expect_alone_as_among_others()
{
    const dRobotModelID model = model_of(kWalker);
    constexpr int kCopies = 37, kSteps = 400;
    Copies<T> many(model, kCopies, dReal(0.004)), threaded(model, kCopies, dReal(0.004), 0, 3);
    for (int i = 0; i < kCopies; ++i)
        disturb(many, model, i, unsigned(i)), disturb(threaded, model, i, unsigned(i));
    dBatchStep(many.id, kSteps), dBatchStep(threaded.id, kSteps);
    for (const int i : {0, 5, 17, 36}) {
        Copies<T> alone(model, 1, dReal(0.004));
        disturb(alone, model, 0, unsigned(i));
        dBatchStep(alone.id, kSteps);
        const auto one = state_of(alone, 0), other = state_of(many, i), third = state_of(threaded, i);
        EXPECT_EQ(std::memcmp(one.data(), other.data(), one.size() * sizeof(T)), 0) << i;
        EXPECT_EQ(std::memcmp(one.data(), third.data(), one.size() * sizeof(T)), 0) << i;
    }
    EXPECT_EQ(dBatchCountBad(many.id), 0);
    dRobotModelDestroy(model);
}

TEST(BatchBits, of_doubles_do_not_depend_on_neighbours_and_threads)
{
    expect_alone_as_among_others<double>();
}
TEST(BatchBits, of_floats_do_not_depend_on_neighbours_and_threads) { expect_alone_as_among_others<float>(); }

template <typename T>
std::uint64_t hash_after(const char* text, int steps)
{
    const dRobotModelID model = model_of(text);
    Copies<T> copies(model, 24, dReal(0.004));
    for (int i = 0; i < 24; ++i) {
        if (text == kWalker) disturb(copies, model, i, unsigned(100 + i));
        if (text == kMixed) {
            Dice dice(unsigned(200 + i));
            const auto q = any_positions(model, dice), v = dice.many(copies.size(dBatchVelocities), -1, 1);
            copies.write_one(dBatchPositions, i, {q.begin(), q.end()}),
                copies.write_one(dBatchVelocities, i, {v.begin(), v.end()});
        }
    }
    dBatchStep(copies.id, steps);
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (int i = 0; i < 24; ++i)
        for (const T x : state_of(copies, i)) hash = hashed(hash, x);
    dRobotModelDestroy(model);
    return hash;
}

// The model's numbers come from libm-free code in doubles, whatever the library's precision.
TEST(BatchBits, are_golden)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "step sizes and states pass through dReal";
    EXPECT_TRUE(golden::is_golden("batch/walker/double", hash_after<double>(kWalker, 500)));
    EXPECT_TRUE(golden::is_golden("batch/walker/float", hash_after<float>(kWalker, 500)));
    EXPECT_TRUE(golden::is_golden("batch/mixed/double", hash_after<double>(kMixed, 500)));
    EXPECT_TRUE(golden::is_golden("batch/mixed/float", hash_after<float>(kMixed, 500)));
}

}  // namespace
}  // namespace epode::tests
