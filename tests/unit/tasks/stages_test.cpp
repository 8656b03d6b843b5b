// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every piece of every stage runs once, none before all of the stage before are done, on any number of
// workers, with a pool or without.
#include "tasks/stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include "taken_pool.h"

namespace epode {
namespace {

// Of stage s; some stages have none.
int pieces_of(int s, int seed) { return (s * 7 + seed * 5) % 11 - 1; }

struct Record {
    int runs = 0, early = 0, strange = 0;
};

Record run(const Tasks& tasks, int stages, int seed)
{
    std::vector<std::atomic<int>> done(static_cast<std::size_t>(stages));
    std::atomic<int> early{0}, strange{0};
    std::vector<std::vector<int>> runs(static_cast<std::size_t>(stages));  // each piece writes its own
    for (int s = 0; s < stages; ++s)
        runs[std::size_t(s)].resize(std::size_t(std::max(0, pieces_of(s, seed))));
    in_stages(
        tasks, stages, [&](int s) { return pieces_of(s, seed); },
        [&](int s, int i, int worker) {
            int before = s - 1;
            while (before >= 0 && pieces_of(before, seed) <= 0) --before;
            if (before >= 0 &&
                done[std::size_t(before)].load(std::memory_order_relaxed) != pieces_of(before, seed))
                ++early;
            if (worker < 0 || worker >= tasks.workers()) ++strange;
            ++runs[std::size_t(s)][std::size_t(i)];
            done[std::size_t(s)].fetch_add(1, std::memory_order_relaxed);
        });
    Record record{0, early, strange};
    for (const auto& of_stage : runs)
        for (const int r : of_stage) record.runs += r == 1 ? 1 : 1000000;
    return record;
}

int expected(int stages, int seed)
{
    int sum = 0;
    for (int s = 0; s < stages; ++s) sum += std::max(0, pieces_of(s, seed));
    return sum;
}

TEST(Stages, run_every_piece_once_and_in_turn)
{
    for (const int workers : {1, 2, 3, 8, 64})
        for (int seed = 0; seed < 200; ++seed) {
            const int stages = seed % 40;
            const Record record = run(Tasks(workers), stages, seed);
            ASSERT_EQ(record.runs, expected(stages, seed)) << workers << ' ' << seed;
            ASSERT_EQ(record.early, 0) << workers << ' ' << seed;
            ASSERT_EQ(record.strange, 0) << workers << ' ' << seed;
        }
}

TEST(Stages, inside_a_piece_run_in_place)
{
    std::atomic<int> sum{0};
    const Tasks tasks(4);
    tasks.for_each(6, [&](int i, int) { sum += run(tasks, 20, i).runs; });
    int wanted = 0;
    for (int i = 0; i < 6; ++i) wanted += expected(20, i);
    EXPECT_EQ(sum, wanted);
}

// Who finds the pool taken does everything alone.
TEST(Stages, wait_for_nobody_who_does_not_come)
{
    const TakenPool taken;
    const Record record = run(Tasks(4), 30, 1);
    EXPECT_EQ(record.runs, expected(30, 1));
    EXPECT_EQ(record.early, 0);
}

TEST(Tasks, ranges_cover_all_without_a_gap)
{
    for (const int workers : {1, 2, 5})
        for (const int count : {0, 1, 255, 256, 257, 5000}) {
            std::vector<std::atomic<int>> seen(static_cast<std::size_t>(count));
            Tasks(workers).in_ranges(count, 256, [&](int first, int last) {
                for (int i = first; i < last; ++i) ++seen[std::size_t(i)];
            });
            for (const auto& s : seen) ASSERT_EQ(s, 1);
        }
}

}  // namespace
}  // namespace epode
