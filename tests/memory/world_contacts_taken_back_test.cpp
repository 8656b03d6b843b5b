// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps that run out of memory in worlds that manage their contacts. Bodies are finished island by island
// (geoms marked, damping, forces emptied), so when memory ends in a later one, others are finished already:
// they must be taken back, and what had not been touched before must not fall asleep a step earlier.
#include "../effort.h"
#include "little_memory.h"

namespace epode::memory {
namespace {

// A wall, a row of towers, and pairs of boxes that hover and drift together so slowly that they may fall
// asleep as soon as they touch.
class Yard {
  public:
    explicit Yard(const Setting& s) : setting_(s)
    {
        set_up(world_, s);
        dWorldSetGravity(world_, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world_, space_);
        dWorldSetDamping(world_, dReal(0.01), dReal(0.02));
        dCreatePlane(space_, 0, 0, 1, 0);
        for (int i = 0; i < 12; ++i)
            for (int k = 0; k < 12; ++k) add(i, 0, dReal(0.5) + k);
        for (int i = 0; i < 90; ++i)
            for (int k = 0; k < 2; ++k) add(2 * i, 5, dReal(0.51) + k);
        for (int i = 0; i < 40; ++i) {
            hover(2 * i, 0);
            hover(2 * i + dReal(1.0002) + dReal(0.0001) * dReal(i), dReal(-0.009));
        }
    }
    ~Yard()
    {
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    Yard(const Yard&) = delete;
    Yard& operator=(const Yard&) = delete;

    dWorldID world() const { return world_; }
    int go() { return step(world_, setting_.stepper, dReal(0.01)); }
    void push() { dBodyAddForce(bodies_[0], 3, 0, 1); }
    // Puts a box on a tower, each time on another one: geoms that a refused step has marked must be noticed.
    void place(int number) { dBodySetPosition(bodies_[322], number % 2 ? 170 : 174, 5, dReal(2.46)); }
    int sleeping() const
    {
        int n = 0;
        for (dBodyID b : bodies_) n += !dBodyIsEnabled(b);
        return n;
    }
    std::uint64_t hash() const
    {
        std::uint64_t hash = hash_of(bodies_);
        for (dBodyID b : bodies_) {
            dReal box[6];
            dGeomGetAABB(dBodyGetFirstGeom(b), box);
            hash = hash * 31 + std::uint64_t(dBodyIsEnabled(b)) + std::uint64_t(std::llround(box[4] * 1e9));
        }
        return hash;
    }

  private:
    dBodyID add(dReal x, dReal y, dReal z)
    {
        dBodyID body = dBodyCreate(world_);
        dBodySetPosition(body, x, y, z);
        dGeomSetBody(dCreateBox(space_, 1, 1, 1), body);
        bodies_.push_back(body);
        return body;
    }
    void hover(dReal x, dReal vx)
    {
        dBodyID body = add(x, 20, 30);
        dBodySetGravityMode(body, 0);
        dBodySetLinearVel(body, vx, 0, 0);
        dBodySetAutoDisableFlag(body, 1);
        dBodySetAutoDisableSteps(body, 1);
        dBodySetAutoDisableTime(body, 0);
        dBodySetAutoDisableLinearThreshold(body, dReal(0.1));
    }

    Setting setting_;
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    std::vector<dBodyID> bodies_;
};

struct WorldContactsTakenBack : testing::TestWithParam<Setting> {};

TEST_P(WorldContactsTakenBack, wherever_the_working_memory_ends)
{
    const Library library;
    Yard poor(GetParam()), rich(GetParam());
    limit_blocks(poor.world());
    int refused = 0, slept = 0;
    for (int i = 0; i < 16 && !testing::Test::HasFailure(); ++i) {
        poor.push(), rich.push();
        const int here =
            step_with_little(poor, GetParam().threads, unsigned(64 * i), 64 * (tests::kSanitized ? 997 : 97),
                             [&](int trial) { poor.place(trial); });
        refused += here;
        rich.place(here);
        EXPECT_EQ(rich.go(), 1);
        EXPECT_EQ(poor.hash(), rich.hash()) << "step " << i;
        slept += rich.sleeping() > 0 && rich.sleeping() < 80;
    }
    EXPECT_GT(refused, tests::effort(100));
    EXPECT_GT(slept, 3) << "pairs fall asleep one after the other";
}

constexpr Setting kSettings[] = {{Stepper::kFast, 1, false}, {Stepper::kFast, 3, true}};

INSTANTIATE_TEST_SUITE_P(Settings, WorldContactsTakenBack, testing::ValuesIn(kSettings), name_of);

}  // namespace
}  // namespace epode::memory
