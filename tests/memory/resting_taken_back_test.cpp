// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps that run out of memory at any allocation where most of a world sleeps: pairs that come back from
// rest, and those that go there, are neither lost nor changed.
#include <algorithm>
#include <tuple>

#include "heap.h"

namespace epode::memory {
namespace {

constexpr int kPiles = 60;

class Piles {
  public:
    Piles()
    {
        dWorldSetGravity(world_, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world_, space_);
        dWorldSetAutoDisableFlag(world_, 1);
        dWorldSetAutoDisableSteps(world_, 3);
        dWorldSetAutoDisableTime(world_, 0);
        dCreatePlane(space_, 0, 0, 1, 0);
        for (int i = 0; i < 2 * kPiles; ++i) {
            const dBodyID body = dBodyCreate(world_);
            dBodySetPosition(body, 3 * (i / 2), 0, dReal(0.5) + i % 2);
            dGeomSetBody(dCreateBox(space_, 1, 1, 1), body);
            bodies_.push_back(body);
        }
    }
    ~Piles()
    {
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    Piles(const Piles&) = delete;
    Piles& operator=(const Piles&) = delete;

    int go() { return step(world_, Stepper::kFast, dReal(0.02)); }
    // A pile is hit, another is lifted in its sleep, and a box comes.
    void disturb(int i)
    {
        dBodyEnable(bodies_[std::size_t(2 * i)]);
        dBodySetLinearVel(bodies_[std::size_t(2 * i)], 1, dReal(0.5), 0);
        const dBodyID lifted = bodies_[std::size_t(2 * i + 21)];
        const dReal* p = dBodyGetPosition(lifted);
        dBodySetPosition(lifted, p[0], p[1], p[2] + dReal(0.3));
        dGeomSetPosition(dCreateBox(space_, 1, 1, 1), 3 * i, 1, 0);
    }
    int sleeping() const
    {
        return int(
            std::count_if(bodies_.begin(), bodies_.end(), [](dBodyID b) { return !dBodyIsEnabled(b); }));
    }
    int size() const { return int(bodies_.size()); }
    // Of all that can be read.
    std::uint64_t hash() const
    {
        std::uint64_t hash = hash_of(bodies_);
        for (const dBodyID body : bodies_) hash = hash * 31 + std::uint64_t(dBodyIsEnabled(body));
        return hash;
    }
    std::vector<std::tuple<dReal, dReal, dReal>> contacts() const
    {
        std::vector<dWorldContact> got(std::size_t(dWorldGetContacts(world_, nullptr, 0)));
        dWorldGetContacts(world_, got.data(), int(got.size()));
        std::vector<std::tuple<dReal, dReal, dReal>> out;
        for (const dWorldContact& c : got) out.emplace_back(c.pos[0], c.pos[2], c.normal_force);
        std::sort(out.begin(), out.end());
        return out;
    }
    std::vector<int> events() const
    {
        std::vector<dContactEvent> got(std::size_t(dWorldGetContactEvents(world_, nullptr, 0)));
        dWorldGetContactEvents(world_, got.data(), int(got.size()));
        std::vector<int> counts(3);
        for (const dContactEvent& event : got) ++counts[std::size_t(event.kind)];
        return counts;
    }

  private:
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    std::vector<dBodyID> bodies_;
};

// How often it was refused; what it has been given it keeps.
int step_with_failures(Piles& piles)
{
    for (int refused = 0;; ++refused) {
        const std::uint64_t before = piles.hash();
        const auto contacts = piles.contacts();
        Heap::fail_at(refused, true);
        const int made = piles.go();
        Heap::count();
        if (made) return refused;
        EXPECT_EQ(piles.hash(), before) << "allocation " << refused;
        EXPECT_EQ(piles.contacts(), contacts) << "allocation " << refused;
        if (testing::Test::HasFailure() || refused > 1000) return refused;
    }
}

TEST(RestingTakenBack, wherever_memory_ends)
{
    const Library library;
    Piles poor, rich;
    int refused = 0, few_awake = 0;
    for (int i = 0; i < 400 && !testing::Test::HasFailure(); ++i) {
        if (i >= 60 && i % 10 == 0) poor.disturb(i / 10), rich.disturb(i / 10);
        // Not in every step, or nothing would ever find room to rest.
        if (i % 10 < 3)
            refused += step_with_failures(poor);
        else
            ASSERT_EQ(poor.go(), 1);
        ASSERT_EQ(rich.go(), 1);
        ASSERT_EQ(poor.hash(), rich.hash()) << "step " << i;
        ASSERT_EQ(poor.contacts(), rich.contacts()) << "step " << i;
        ASSERT_EQ(poor.events(), rich.events()) << "step " << i;
        const int awake = rich.size() - rich.sleeping();
        few_awake += awake > 0 && 16 * awake <= rich.size();
    }
    EXPECT_GT(refused, 10);
    EXPECT_GT(few_awake, 100);
}

}  // namespace
}  // namespace epode::memory
