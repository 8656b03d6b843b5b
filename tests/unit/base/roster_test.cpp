// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A roster against a plain list, through thousands of comings and goings.
#include "base/objects/roster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../math/random_numbers.h"

namespace epode {
namespace {

struct Member {
    int place = -1;
};

using Members = Roster<Member, 1>;

std::vector<const Member*> newest_first(const Members& roster)
{
    std::vector<const Member*> all;
    for (Member& m : roster) all.push_back(&m);
    return all;
}

TEST(Roster, is_walked_from_the_newest_on_whoever_has_left)
{
    RandomNumbers random(3);
    std::vector<Member> members(500);
    Members roster;
    std::vector<const Member*> list;  // the newest last
    int most_places = 0;
    for (int round = 0; round < 20000; ++round) {
        // Ebb and flow, so that it is nearly empty at times and holes are closed up.
        const bool flow = round / 1000 % 2 == 0;
        Member& one = members[std::size_t(random.in(0, Real(499.99)))];
        if (one.place < 0 && (flow || random.in(0, 1) < Real(0.2))) {
            ASSERT_TRUE(roster.join(one));
            list.push_back(&one);
        } else if (one.place >= 0 && (!flow || random.in(0, 1) < Real(0.2))) {
            roster.leave(one);
            list.erase(std::find(list.begin(), list.end(), &one));
            EXPECT_EQ(one.place, -1);
        }
        ASSERT_EQ(roster.count(), int(list.size()));
        ASSERT_LE(roster.places(), 2 * roster.count() + 64);
        most_places = std::max(most_places, roster.places() - roster.count());
        if (round % 50 != 0) continue;
        ASSERT_EQ(newest_first(roster), std::vector<const Member*>(list.rbegin(), list.rend()));
    }
    EXPECT_GT(most_places, 32);  // there were holes
}

TEST(Roster, closes_the_end_at_once)
{
    Member a, b, c;
    Members roster;
    ASSERT_TRUE(roster.join(a) && roster.join(b) && roster.join(c));
    roster.leave(b);
    EXPECT_EQ(roster.places(), 3);
    roster.leave(c);
    EXPECT_EQ(roster.places(), 1);
    EXPECT_EQ(&roster.newest(), &a);
    EXPECT_EQ(newest_first(roster), std::vector<const Member*>{&a});
    roster.leave(a);
    EXPECT_EQ(roster.places(), 0);
    EXPECT_TRUE(newest_first(roster).empty());
}

TEST(Roster, who_joins_later_is_not_before_an_earlier_place)
{
    Member a, b, c;
    Members roster;
    ASSERT_TRUE(roster.join(a) && roster.join(b));
    const int then = roster.places();
    ASSERT_TRUE(roster.join(c));
    std::vector<const Member*> met;
    for (Member& m : roster.before(then)) met.push_back(&m);
    EXPECT_EQ(met, (std::vector<const Member*>{&b, &a}));
}

TEST(Roster, walks_over_the_active_alone_whoever_has_left)
{
    RandomNumbers random(7);
    std::vector<Member> members(700);
    Members roster;
    std::vector<const Member*> active;  // the newest last
    const auto forget = [&](const Member& one) {
        active.erase(std::remove(active.begin(), active.end(), &one), active.end());
    };
    for (int round = 0; round < 20000; ++round) {
        const bool flow = round / 1500 % 2 == 0;
        Member& one = members[std::size_t(random.in(0, Real(699.99)))];
        if (one.place < 0 && (flow || random.in(0, 1) < Real(0.1))) {
            ASSERT_TRUE(roster.join(one));
            EXPECT_TRUE(roster.is_active(one));
            active.push_back(&one);
        } else if (one.place >= 0 && !flow && random.in(0, 1) < Real(0.5)) {
            roster.leave(one);
            forget(one);
        } else if (one.place >= 0 && roster.is_active(one)) {
            roster.deactivate(one);
            forget(one);
        } else if (one.place >= 0) {
            roster.activate(one), roster.activate(one);  // the second time in vain
            const auto older = [&](const Member* other) { return other->place < one.place; };
            active.insert(std::partition_point(active.begin(), active.end(), older), &one);
        }
        ASSERT_EQ(roster.active_count(), int(active.size()));
        if (round % 20 != 0) continue;
        std::vector<const Member*> walked;
        roster.for_each_active([&](const Member& m) { walked.push_back(&m); });
        ASSERT_EQ(walked, std::vector<const Member*>(active.rbegin(), active.rend()));
        const int limit = int(random.in(0, Real(roster.places()) + 1));
        walked.clear();
        roster.for_each_active_before(limit, [&](const Member& m) { walked.push_back(&m); });
        for (const Member* m : walked) ASSERT_LT(m->place, limit);
        const auto below =
            std::count_if(active.begin(), active.end(), [&](const Member* m) { return m->place < limit; });
        ASSERT_EQ(std::ptrdiff_t(walked.size()), below);
    }
}

}  // namespace
}  // namespace epode
