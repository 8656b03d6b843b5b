// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every piece runs exactly once, whatever the number of workers, and many short jobs in a row never take a
// piece of one another.
#include "tasks/tasks.h"

#include <gtest/gtest.h>
#if !defined(_WIN32) && !defined(__wasm__)
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <atomic>
#include <thread>
#include <vector>

#include "taken_pool.h"
#include "tasks/thread_pool.h"
#include "tasks/waiting.h"

namespace epode {
namespace {

TEST(Tasks, every_piece_runs_once_on_a_worker_that_exists)
{
    for (int workers : {1, 2, 3, 8}) {
        const Tasks tasks(workers);
        std::vector<std::atomic<int>> runs(1000);
        std::atomic<int> strange{0};
        tasks.for_each(1000, [&](int i, int worker) {
            ++runs[std::size_t(i)];
            if (worker < 0 || worker >= workers) ++strange;
        });
        for (auto& r : runs) ASSERT_EQ(r, 1);
        EXPECT_EQ(strange, 0);
    }
}

TEST(Tasks, many_short_jobs_of_changing_width_lose_and_repeat_nothing)
{
    for (int job = 0; job < 20000; ++job) {
        const int count = 1 + job % 7, workers = 1 + job % 5;
        std::atomic<int> sum{0}, widest{0};
        Tasks(workers).for_each(count, [&](int i, int worker) {
            sum += i + 1;
            if (worker >= workers) widest = worker;
        });
        ASSERT_EQ(sum, count * (count + 1) / 2) << job;
        ASSERT_EQ(widest, 0) << job;
    }
}

TEST(Tasks, a_job_inside_a_piece_runs_in_place)
{
    std::atomic<int> sum{0}, elsewhere{0};
    const Tasks tasks(4);
    tasks.for_each(16, [&](int, int outer) {
        tasks.for_each(8, [&](int i, int inner) {
            sum += i;
            if (inner != outer) ++elsewhere;
        });
    });
    EXPECT_EQ(sum, 16 * 28);
    EXPECT_EQ(elsewhere, 0);
}

// Also when the pool, which another thread had, is free again before the job inside begins.
TEST(Tasks, a_job_inside_a_piece_runs_in_place_when_the_pool_was_taken)
{
    TakenPool pool;
    const Tasks tasks(3);
    std::atomic<int> elsewhere{0};
    tasks.for_each(4, [&](int, int outer) {
        const std::thread::id here = std::this_thread::get_id();
        pool.give_back();
        tasks.for_each(100, [&](int, int inner) {
            if (inner != outer || std::this_thread::get_id() != here) ++elsewhere;
        });
    });
    EXPECT_EQ(elsewhere, 0);
}

TEST(Tasks, know_when_nobody_would_help)
{
    EXPECT_TRUE(Tasks(1).alone());
    const Tasks tasks(3);
    {
        const TakenPool taken;
        EXPECT_TRUE(tasks.alone());
    }
    std::atomic<int> hoped{0};
    tasks.for_each(8, [&](int, int) { hoped += !tasks.alone(); });
    EXPECT_EQ(hoped, 0);
    // On a busy machine the pool may rest after the tests before, but never for longer than its limit.
    for (const auto begin = nanoseconds_now(); tasks.alone();)
        ASSERT_LT(nanoseconds_now() - begin, 2 * HelpBalance::kMaxRest);
}

TEST(Tasks, callers_on_several_threads_share_the_pool)
{
    std::atomic<long> total{0};
    std::vector<std::thread> callers;
    for (int t = 0; t < 3; ++t)
        callers.emplace_back([&] {
            for (int job = 0; job < 500; ++job) Tasks(3).for_each(20, [&](int i, int) { total += i; });
        });
    for (std::thread& t : callers) t.join();
    EXPECT_EQ(total, 3L * 500 * 190);
}

TEST(Tasks, the_pool_stops_and_starts_again)
{
    for (int round = 0; round < 20; ++round) {
        std::atomic<int> sum{0};
        Tasks(4).for_each(100, [&](int, int) { ++sum; });
        EXPECT_EQ(sum, 100);
        thread_pool().stop();
    }
}

// The thread sanitizer cannot follow a fork of a process with threads; Windows and WebAssembly have no forks.
#if !defined(__SANITIZE_THREAD__) && !defined(_WIN32) && !defined(__wasm__)
TEST(Tasks, a_forked_child_has_a_pool_of_its_own)
{
    Tasks(4).for_each(100, [](int, int) {});
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        alarm(20);  // a child that hangs is a failure
        std::atomic<int> sum{0};
        Tasks(4).for_each(100, [&](int, int) { ++sum; });
        _exit(sum == 100 ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}
#endif

}  // namespace
}  // namespace epode
