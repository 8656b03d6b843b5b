// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "collide/pairs/surfaces/crossing_table.h"

#include <gtest/gtest.h>

namespace epode {
namespace {

// Of a hundred thousand contacts only those under the two numbers are looked at.
TEST(CrossingTable, looks_at_what_was_put_under_both_numbers_alone)
{
    constexpr int kSide = 300;
    CrossingTable table;
    ASSERT_TRUE(table.reserve(kSide * kSide));
    for (int i = 0; i < kSide * kSide; ++i) table.put(std::uint64_t(i / kSide), std::uint64_t(i % kSide), i);
    for (const int wanted : {0, 17, kSide * kSide - 1}) {
        int looks = 0;
        const auto look = [&](int contact) {
            ++looks;
            EXPECT_EQ(contact, wanted);
            return false;
        };
        EXPECT_FALSE(table.any(std::uint64_t(wanted / kSide), std::uint64_t(wanted % kSide), look));
        EXPECT_EQ(looks, 1);
    }
    const auto yes = [](int) { return true; };
    EXPECT_TRUE(table.any(5, 7, yes));
    EXPECT_FALSE(table.any(5, kSide, yes));
    ASSERT_TRUE(table.reserve(4));
    EXPECT_FALSE(table.any(5, 7, yes)) << "emptied";
}

}  // namespace
}  // namespace epode
