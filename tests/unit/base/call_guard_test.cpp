// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Guards that end, and guards that are left: each is undone once, and none that is not left. Here the library is part
// of the program, so that frames tell less than they do of a shared library (tests/hostile/escapes_test.cpp).
#include "base/call_guard.h"

#include <gtest/gtest.h>

#include <csetjmp>
#include <functional>
#include <thread>
#include <vector>
#if defined(__linux__)
#include <ucontext.h>
#endif

namespace epode {
namespace {

void count(void* undone, const void*, std::size_t) { ++*static_cast<int*>(undone); }

std::jmp_buf g_landing;

[[gnu::noinline]] void deeper(int bytes, const std::function<void()>& work)
{
    volatile char* frame = static_cast<volatile char*>(__builtin_alloca(std::size_t(bytes)));
    frame[0] = 0;
    work();
    frame[bytes - 1] = 0;
}

[[gnu::noinline]] void jump() { std::longjmp(g_landing, 1); }

[[gnu::noinline]] void leave_holding(int* undone, int guards)
{
    const CallGuard guard(count, undone);
    guards > 1 ? leave_holding(undone, guards - 1) : jump();
}

void leave(int* undone, int guards = 1)
{
    if (setjmp(g_landing) == 0) leave_holding(undone, guards);
}

TEST(CallGuards, end_once)
{
    int undone = 0;
    EXPECT_FALSE(CallGuard::any());
    {
        const CallGuard guard(count, &undone), none(nullptr, &undone);
        CallGuard ended(count, &undone);
        EXPECT_TRUE(CallGuard::any());
        EXPECT_TRUE(ended.end());
        EXPECT_FALSE(ended.end());
        EXPECT_EQ(undone, 0);
    }
    EXPECT_EQ(undone, 1);
    EXPECT_FALSE(CallGuard::any());
}

// Those of one function lie on its stack in any order.
TEST(CallGuards, of_one_function_are_not_left)
{
    int undone = 0;
    {
        const CallGuard a(count, &undone), b(count, &undone), c(count, &undone), d(count, &undone);
        deeper(1000, [&] {
            const CallGuard e(count, &undone), f(count, &undone);
            CallGuard::release_left();
            EXPECT_EQ(undone, 0);
        });
        EXPECT_EQ(undone, 2);
        deeper(20000, [] { CallGuard::release_left(); });
        EXPECT_EQ(undone, 2);
    }
    EXPECT_EQ(undone, 6);
    EXPECT_FALSE(CallGuard::any());
}

// A frame here that ends within 512 bytes of where theirs did could be theirs: none does.
TEST(CallGuards, that_are_left_are_undone)
{
    for (const int guards : {1, 3, 10})
        for (const int depth : {0, 4000, 20000}) {
            int undone = 0;
            leave(&undone, guards);
            EXPECT_EQ(undone, 0);
            depth > 0 ? deeper(depth, [] { CallGuard::release_left(); }) : CallGuard::release_left();
            EXPECT_EQ(undone, guards) << depth;
            EXPECT_FALSE(CallGuard::any());
        }
}

TEST(CallGuards, that_are_left_are_undone_when_an_outer_one_ends)
{
    int inner = 0, outer = 0;
    {
        const CallGuard guard(count, &outer);
        leave(&inner, 20);
    }
    EXPECT_EQ(inner, 20);
    EXPECT_EQ(outer, 1);
    EXPECT_FALSE(CallGuard::any());
}

TEST(CallGuards, that_are_left_are_undone_when_the_call_is_made_again)
{
    int undone = 0;
    for (int i = 0; i < 50; ++i) leave(&undone);
    EXPECT_GE(undone, 49);
    CallGuard::release_left();
    EXPECT_EQ(undone, 50);
}

TEST(CallGuards, belong_to_their_thread)
{
    int undone = 0;
    const CallGuard guard(count, &undone);
    std::thread([&] {
        EXPECT_FALSE(CallGuard::any());
        int here = 0;
        leave(&here, 2);
        CallGuard::release_left();
        EXPECT_EQ(here, 2);
    }).join();
    EXPECT_EQ(undone, 0);
}

TEST(CallGuards, that_are_left_are_undone_when_their_thread_ends)
{
    int undone = 0;
    std::thread([&] { leave(&undone, 40); }).join();
    EXPECT_EQ(undone, 40);
}

#if defined(__linux__)

// A coroutine that waits inside a call, and one that goes on meanwhile.
ucontext_t g_main, g_one;
int g_undone = 0;
void wait_inside()
{
    const CallGuard guard(count, &g_undone);
    swapcontext(&g_one, &g_main);
}

TEST(CallGuards, of_coroutines_are_not_judged)
{
    std::vector<char> stack(1 << 16);
    getcontext(&g_one);
    g_one.uc_stack = {stack.data(), 0, stack.size()};
    g_one.uc_link = &g_main;
    makecontext(&g_one, wait_inside, 0);
    swapcontext(&g_main, &g_one);
    int undone = 0;
    {
        const CallGuard guard(count, &undone);
        deeper(3000, [] { CallGuard::release_left(); });
        EXPECT_EQ(g_undone, 0);
    }
    EXPECT_EQ(undone, 1);
    EXPECT_EQ(g_undone, 0);
    swapcontext(&g_main, &g_one);
    EXPECT_EQ(g_undone, 1);
    EXPECT_FALSE(CallGuard::any());
}

#endif

}  // namespace
}  // namespace epode
