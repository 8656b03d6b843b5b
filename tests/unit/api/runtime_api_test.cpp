// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Initialisation, configuration, memory, messages, random numbers and timers.
#include <gtest/gtest.h>

#include <chrono>
#if !defined(__wasm__)
#include <csignal>
#endif
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "message_recorder.h"

namespace {

TEST(Init, counts_and_refuses_an_unbalanced_close)
{
    MessageRecorder messages;
    EXPECT_EQ(dInitODE2(0), 1);
    dInitODE();
    EXPECT_EQ(dAllocateODEDataForThread(~0u), 1);
    dCleanupODEAllDataForThread();
    dCloseODE();
    EXPECT_EQ(dAllocateODEDataForThread(0), 1) << "still open once";
    dCloseODE();
    EXPECT_EQ(messages.take(), "");
    dCloseODE();
    EXPECT_EQ(messages.take(),
              "2: dCloseODE must not be called without dInitODE2 or if dInitODE2 fails in dCloseODE()");
    EXPECT_EQ(dAllocateODEDataForThread(0), 0);
    EXPECT_EQ(messages.take(), "2: Call dInitODE2 first in dAllocateODEDataForThread()");
    dCleanupODEAllDataForThread();
    EXPECT_EQ(
        messages.take(),
        "2: Call dInitODE2 first or delay dCloseODE until all threads exit in dCleanupODEAllDataForThread()");
    EXPECT_EQ(dInitODE2(dInitFlagManualThreadCleanup), 1) << "may be opened again";
    dCloseODE();
    EXPECT_EQ(messages.take(), "");
}

TEST(Configuration, is_found_word_by_word)
{
    MessageRecorder messages;
    const std::string all = dGetConfiguration();
    EXPECT_EQ(dCheckConfiguration("ODE"), 1);
    EXPECT_EQ(dCheckConfiguration("ODE_double_precision"), sizeof(dReal) == 8);
    EXPECT_EQ(dCheckConfiguration("ODE_single_precision"), sizeof(dReal) == 4);
    for (std::size_t begin = 0; begin < all.size();) {
        const std::size_t end = std::min(all.find(' ', begin), all.size());
        EXPECT_EQ(dCheckConfiguration(all.substr(begin, end - begin).c_str()), 1);
        begin = end + 1;
    }
    for (const char* no : {"OD", "DE", "ODE_", "ode", "precision"})
        EXPECT_EQ(dCheckConfiguration(no), 0) << "'" << no << "'";
    for (const char* no_word : {"", " ", "ODE ", " ODE", "ODE ODE"})
        EXPECT_EQ(dCheckConfiguration(no_word), 1) << "'" << no_word << "', as ODE answers";
    EXPECT_EQ(messages.take(), "");
    EXPECT_EQ(dCheckConfiguration(nullptr), 0);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dCheckConfiguration()");
}

int g_live_blocks = 0;

TEST(MemoryApi, goes_through_the_clients_handlers)
{
    EXPECT_EQ(dGetAllocHandler(), nullptr);
    dAllocFunction* take = [](dsizeint size) -> void* { return ++g_live_blocks, std::malloc(size); };
    dReallocFunction* grow = [](void* p, dsizeint, dsizeint size) -> void* { return std::realloc(p, size); };
    dFreeFunction* give = [](void* p, dsizeint) { --g_live_blocks, std::free(p); };
    dSetAllocHandler(take);
    dSetReallocHandler(grow);
    dSetFreeHandler(give);
    EXPECT_EQ(dGetAllocHandler(), take);
    EXPECT_EQ(dGetReallocHandler(), grow);
    EXPECT_EQ(dGetFreeHandler(), give);
    char* p = static_cast<char*>(dAlloc(10));
    p[9] = 'x';
    EXPECT_EQ(g_live_blocks, 1);
    p = static_cast<char*>(dRealloc(p, 10, 1000));
    EXPECT_EQ(p[9], 'x');
    dFree(p, 1000);
    EXPECT_EQ(g_live_blocks, 0);
    dFree(nullptr, 10);
    EXPECT_EQ(g_live_blocks, 0) << "a null pointer never reaches the handler";
    dSetAllocHandler(nullptr);
    dSetReallocHandler(nullptr);
    dSetFreeHandler(nullptr);
    EXPECT_EQ(dGetFreeHandler(), nullptr);
    dFree(dAlloc(10), 10);
    EXPECT_EQ(g_live_blocks, 0);
}

TEST(ErrorApi, the_clients_own_fatal_calls_end_the_program)
{
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(dError(7, "boom %d", 3), testing::ExitedWithCode(1), "ODE Error 7: boom 3");
#if defined(_WIN32)
    EXPECT_DEATH(dDebug(0, "boom %d", 3), "ODE INTERNAL ERROR: boom 3");
#else
    EXPECT_EXIT(dDebug(0, "boom %d", 3), testing::KilledBySignal(SIGABRT), "ODE INTERNAL ERROR: boom 3");
#endif
    EXPECT_EXIT(
        {
            dSetErrorHandler(
                [](int number, const char*, va_list) { std::fprintf(stderr, "mine %d\n", number); });
            dError(4, "unseen");
        },
        testing::ExitedWithCode(1), "^mine 4\n$");
}

TEST(ErrorApi, handlers_are_kept_per_channel)
{
    dMessageFunction* a = [](int, const char*, va_list) {};
    dMessageFunction* b = [](int, const char*, va_list) { std::fputs("b", stderr); };
    dSetErrorHandler(a);
    dSetMessageHandler(b);
    EXPECT_EQ(dGetErrorHandler(), a);
    EXPECT_EQ(dGetDebugHandler(), nullptr);
    EXPECT_EQ(dGetMessageHandler(), b);
    testing::internal::CaptureStderr();
    dMessage(1, "to b");
    dSetErrorHandler(nullptr);
    dSetMessageHandler(nullptr);
    dMessage(1, "printed %s", "here");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "b\nODE Message 1: printed here\n");
}

TEST(RandomApi, follows_odes_sequences)
{
    EXPECT_EQ(dTestRand(), 1);
    dRandSetSeed(0);
    for (unsigned long expected : {0x3c6ef35ful, 0x47502932ul, 0xd1ccf6e9ul, 0xaaf95334ul, 0x6252e503ul})
        EXPECT_EQ(dRand(), expected);
    EXPECT_EQ(dRandGetSeed(), 0x6252e503ul);
    EXPECT_EQ(dTestRand(), 1);
    EXPECT_EQ(dRandGetSeed(), 0x6252e503ul) << "the self test leaves the sequence alone";
    dRandSetSeed((unsigned long)0x123456789ull);
    EXPECT_EQ(dRandGetSeed(), 0x23456789ul);
}

TEST(RandomApi, integers_fill_their_range_evenly)
{
    dRandSetSeed(1);
    for (int n : {1, 2, 3, 5, 17, 100, 300}) {
        std::vector<int> hits(std::size_t(n), 0);
        for (int i = 0; i < 1000 * n; ++i) {
            const int r = dRandInt(n);
            ASSERT_GE(r, 0);
            ASSERT_LT(r, n);
            ++hits[std::size_t(r)];
        }
        // Folded bits are coarse: for n = 3 out of 4 values, one gets twice its share.
        for (int h : hits) EXPECT_GT(h, 500) << n;
    }
    for (int i = 0; i < 1000; ++i) {
        EXPECT_GE(dRandInt(2000000000), 0);
        EXPECT_GE(dRandReal(), 0);
        EXPECT_LE(dRandReal(), 1);
    }
    const unsigned long seed = dRandGetSeed();
    EXPECT_EQ(dRandInt(0), 0);
    EXPECT_EQ(dRandInt(-5), 0);
    EXPECT_NE(dRandGetSeed(), seed);
}

TEST(RandomApi, no_number_is_handed_out_twice_to_two_threads)
{
    dRandSetSeed(0);
    const auto draw = [] {
        for (int i = 0; i < 20000; ++i) dRand();
    };
    std::thread other(draw);
    draw();
    other.join();
    const unsigned long together = dRandGetSeed();
    dRandSetSeed(0);
    for (int i = 0; i < 40000; ++i) dRand();
    EXPECT_EQ(together, dRandGetSeed());
}

TEST(MiscApi, random_matrices_and_their_differences)
{
    dReal A[8] = {9, 9, 9, 9, 9, 9, 9, 9}, B[8];
    dRandSetSeed(0);
    dMakeRandomMatrix(A, 2, 3, 1);
    EXPECT_NEAR(A[0], -0.5278640542, 1e-6);
    EXPECT_NEAR(A[4], 0.3357337958, 1e-6);
    EXPECT_EQ(A[3], 9) << "padding is left alone";
    for (int i = 0; i < 8; ++i) B[i] = A[i];
    EXPECT_EQ(dMaxDifference(A, B, 2, 3), 0);
    B[1] += 2;
    B[4] -= 1;
    EXPECT_NEAR(dMaxDifference(A, B, 2, 3), 2, 1e-6);
    EXPECT_NEAR(dMaxDifferenceLowerTriangle(A, B, 2), 1, 1e-6);
    dReal C[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    dClearUpperTriangle(C, 2);
    EXPECT_EQ(C[1], 0);
    EXPECT_EQ(C[2], 3);
    EXPECT_EQ(C[4], 5);
}

std::string written(const std::function<void(FILE*)>& write)
{
    FILE* file = std::tmpfile();
    write(file);
    std::rewind(file);
    std::string text;
    for (int c; (c = std::fgetc(file)) != EOF;) text += char(c);
    std::fclose(file);
    return text;
}

TEST(MiscApi, matrices_are_printed_row_by_row)
{
    const dReal A[8] = {1, 2, 3, 0, 5, 6, 7, 0};
    EXPECT_EQ(written([&](FILE* f) { dPrintMatrix(A, 2, 3, "<%g>", f); }), "<1><2><3>\n<5><6><7>\n");
    MessageRecorder messages;
    dPrintMatrix(nullptr, 1, 1, "%g", stdout);
    dMakeRandomVector(nullptr, 1, 1);
    EXPECT_EQ(messages.take(),
              "2: Bad argument(s) in dPrintMatrix()|2: Bad argument(s) in dMakeRandomVector()");
}

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

TEST(TimerApi, a_stopwatch_adds_up_what_runs_between_start_and_stop)
{
    dStopwatch watch;
    dStopwatchReset(&watch);
    EXPECT_EQ(dStopwatchTime(&watch), 0);
    for (int i = 1; i <= 2; ++i) {
        dStopwatchStart(&watch);
        wait_a_little();
        dStopwatchStop(&watch);
        EXPECT_GE(dStopwatchTime(&watch), 0.005 * i);
    }
    const double stopped = dStopwatchTime(&watch);
    wait_a_little();
    EXPECT_EQ(dStopwatchTime(&watch), stopped);
    EXPECT_GT(dTimerTicksPerSecond(), 0);
    EXPECT_GT(dTimerResolution(), 0);
    EXPECT_LT(dTimerResolution(), 0.1);
}

TEST(TimerApi, a_report_lists_the_slots_and_the_total)
{
    dTimerStart("first");
    wait_a_little();
    dTimerNow("a longer name");
    dTimerEnd();
    const std::string report = written([](FILE* f) { dTimerReport(f, 1); });
    EXPECT_EQ(report.rfind("\nTimer Report (", 0), 0u);
    EXPECT_NE(report.find("\nfirst         "), std::string::npos) << report;
    EXPECT_NE(report.find("\na longer name "), std::string::npos) << report;
    EXPECT_NE(report.find("\nTOTAL         "), std::string::npos) << report;
    EXPECT_NE(report.find("100.00%  (avg "), std::string::npos) << report;
    for (int i = 0; i < 300; ++i) dTimerNow("many");
    dTimerEnd();
    const std::string full = written([](FILE* f) { dTimerReport(f, 0); });
    EXPECT_NE(full.find("\nTOTAL "), std::string::npos) << "the last slot is kept for the total";
}

TEST(TimerApi, refuses_null)
{
    MessageRecorder messages;
    dStopwatchReset(nullptr);
    EXPECT_EQ(dStopwatchTime(nullptr), 0);
    dTimerNow(nullptr);
    dTimerReport(nullptr, 0);
    EXPECT_EQ(messages.take(),
              "2: Bad argument(s) in dStopwatchReset()|2: Bad argument(s) in dStopwatchTime()|"
              "2: Bad argument(s) in dTimerNow()|2: Bad argument(s) in dTimerReport()");
}

int times(const std::string& text, const std::string& part)
{
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(SelfTestApi, passes_leaves_the_sequence_of_d_rand_alone_and_gives_its_memory_back)
{
    dRandSetSeed(5);
    dSetAllocHandler([](dsizeint size) { return ++g_live_blocks, std::malloc(size); });
    dSetFreeHandler([](void* p, dsizeint) { --g_live_blocks, std::free(p); });
    const int before = g_live_blocks;
    testing::internal::CaptureStdout();
    const int solved = dTestSolveLCP();
    dTestDataStructures();
    std::fflush(stdout);
    const std::string printed = testing::internal::GetCapturedStdout();
    EXPECT_EQ(g_live_blocks, before);
    dSetAllocHandler(nullptr);
    dSetFreeHandler(nullptr);
    EXPECT_EQ(solved, 1);
    EXPECT_EQ(times(printed, "passed"), 6) << printed;
    EXPECT_EQ(times(printed, "FAILED"), 0) << printed;
    EXPECT_EQ(dRandGetSeed(), 5ul);
}

TEST(SelfTestApi, says_no_when_there_is_no_memory)
{
    dSetAllocHandler([](dsizeint) -> void* { return nullptr; });
    testing::internal::CaptureStdout();
    const int solved = dTestSolveLCP();
    dTestDataStructures();
    std::fflush(stdout);
    const std::string printed = testing::internal::GetCapturedStdout();
    dSetAllocHandler(nullptr);
    EXPECT_EQ(solved, 0);
    EXPECT_EQ(times(printed, "FAILED"), 6) << printed;
}

}  // namespace
