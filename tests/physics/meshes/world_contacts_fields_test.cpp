// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// World-managed contacts on height fields that change under what has come to rest on them.
#include <array>

#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr int kSamples = 9;

struct WorldContactsOnFields : testing::Test {
    WorldContactsSim sim{Stepper::kFast};
    dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    std::array<double, kSamples * kSamples> heights{};
    dBodyID ball, box;

    WorldContactsOnFields()
    {
        sim.gravity(0, -9.81, 0);
        dCreateHeightfield(sim.space, data, 1);
        ball = sim.sphere({-1.4, 0.5, 0.3}, 0.5, 1), box = sim.box({1.3, 0.5, 0.2}, {1, 1, 1}, 1);
    }
    ~WorldContactsOnFields() override { dGeomHeightfieldDataDestroy(data); }

    void build(bool copy)
    {
        dGeomHeightfieldDataBuildDouble(data, heights.data(), copy, 8, 8, kSamples, kSamples, 1, 0, 10, 0);
    }
    void expect_at(double height, const char* when) const
    {
        for (const dBodyID b : {ball, box}) EXPECT_NEAR(position(b).y, height + 0.5, 0.02) << when;
    }
    void expect_below(double height) const
    {
        for (const dBodyID b : {ball, box}) EXPECT_LT(position(b).y, height);
    }
};

TEST_F(WorldContactsOnFields, let_fall_what_stood_where_a_hole_is_made)
{
    build(true);
    sim.run(60);
    expect_at(0, "before");
    for (int j = 0; j < kSamples - 1; ++j)
        for (int i = 0; i < kSamples - 1; ++i) dGeomHeightfieldDataSetHole(data, i, j, 1);
    sim.run(60);
    expect_below(-2);
}

TEST_F(WorldContactsOnFields, let_fall_what_stood_on_higher_ones)
{
    build(true);
    sim.run(60);
    expect_at(0, "before");
    heights.fill(-0.5);
    build(true);
    sim.run(90);
    expect_at(-0.5, "built again");
}

TEST_F(WorldContactsOnFields, whose_heights_are_the_programs_are_looked_at_in_every_step)
{
    build(false);
    dGeomHeightfieldDataSetBounds(data, -2, 2);
    sim.run(60);
    expect_at(0, "before");
    heights.fill(-0.5);
    sim.run(90);
    expect_at(-0.5, "written into");
}

TEST_F(WorldContactsOnFields, whose_heights_a_function_returns_are_queried_in_every_step)
{
    static double level;
    level = 0;
    const auto height = [](void*, int, int) { return real(level); };
    dGeomHeightfieldDataBuildCallback(data, nullptr, height, 8, 8, kSamples, kSamples, 1, 0, 10, 0);
    dGeomHeightfieldDataSetBounds(data, -2, 2);
    sim.run(60);
    expect_at(0, "before");
    level = -0.5;
    sim.run(90);
    expect_at(-0.5, "after");
}

TEST_F(WorldContactsOnFields, let_fall_what_stood_on_destroyed_ones)
{
    build(true);
    sim.run(60);
    dGeomHeightfieldDataDestroy(data);
    data = dGeomHeightfieldDataCreate();
    sim.run(60);
    expect_below(-2);
}

}  // namespace
}  // namespace epode::physics
