// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Refusals, notes, close hooks and the solver's random numbers.
#include "base/messages.h"

#include <gtest/gtest.h>

#include <string>

#include "base/check.h"
#include "base/objects/lifecycle.h"
#include "base/random.h"

namespace epode {
namespace {

int g_received = 0;
std::string g_text;

void receive(int number, const char* format, va_list arguments)
{
    char text[200];
    std::vsnprintf(text, sizeof text, format, arguments);
    ++g_received;
    g_text = std::to_string(number) + ": " + text;
}

int half_of(int x)
{
    EPODE_USER(x % 2 == 0, -1);
    return x / 2;
}

void say_hello(const char* name) { EPODE_USER_SAY(name, "no name to greet"); }

TEST(Refusal, reaches_the_debug_handler_every_time)
{
    g_received = 0;
    set_handler(Channel::kDebug, &receive);
    EXPECT_EQ(half_of(3), -1);
    EXPECT_EQ(half_of(5), -1);
    EXPECT_EQ(half_of(6), 3);
    EXPECT_EQ(g_received, 2);
    EXPECT_EQ(g_text, "2: Bad argument(s) in half_of()");
    say_hello(nullptr);
    EXPECT_EQ(g_text, "2: no name to greet in say_hello()");
    set_handler(Channel::kDebug, nullptr);
}

int third_of(int x)
{
    EPODE_USER(x % 3 == 0, -1);
    return x / 3;
}

TEST(Refusal, is_printed_once_per_call_site_without_a_handler)
{
    testing::internal::CaptureStderr();
    EXPECT_EQ(third_of(1), -1);
    EXPECT_EQ(third_of(2), -1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "\nODE INTERNAL ERROR 2: Bad argument(s) in third_of()\n");
}

TEST(Note, prints_its_number_unless_it_is_zero)
{
    testing::internal::CaptureStderr();
    note(3, "pivot %d", 7);
    note(0, "plain");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "\nODE Message 3: pivot 7\n\nODE Message: plain\n");
}

TEST(Usable, refuses_what_no_simulation_can_mean)
{
    EXPECT_TRUE(usable(Real(0)));
    EXPECT_TRUE(usable(-kMaxMagnitude));
    EXPECT_FALSE(usable(kInf));
    EXPECT_FALSE(usable(-kInf));
    EXPECT_FALSE(usable(std::numeric_limits<Real>::quiet_NaN()));
    EXPECT_FALSE(usable(2 * kMaxMagnitude));
    EXPECT_TRUE(usable_or_infinite(kInf));
    EXPECT_FALSE(usable_or_infinite(std::numeric_limits<Real>::quiet_NaN()));
    const Real three[] = {1, 2, kInf};
    EXPECT_TRUE(usable(three, 2));
    EXPECT_FALSE(usable(three, 3));
}

std::string g_order;
void first() { g_order += "1"; }
void second() { g_order += "2"; }

TEST(CloseHooks, run_newest_first_and_each_once)
{
    EXPECT_TRUE(on_last_close(&first));
    EXPECT_TRUE(on_last_close(&second));
    EXPECT_TRUE(on_last_close(&first));
    EXPECT_FALSE(on_last_close(nullptr));
    g_order.clear();
    run_close_hooks();
    EXPECT_EQ(g_order, "21");
    run_close_hooks();
    EXPECT_EQ(g_order, "2121") << "hooks stay for the next life of the library";
}

TEST(CounterRandom, depends_on_key_and_count_alone_and_fills_its_range)
{
    CounterRandom a(5), b(5), c(6);
    int hits[10] = {};
    bool differs = false;
    for (int i = 0; i < 10000; ++i) {
        const std::uint64_t x = a.next();
        EXPECT_EQ(x, b.next());
        differs |= x != c.next();
        ++hits[a.below(10)];
        b.next();
    }
    EXPECT_TRUE(differs);
    // 1000 expected, standard deviation 30.
    for (int h : hits) EXPECT_NEAR(h, 1000, 180);
}

}  // namespace
}  // namespace epode
