// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which joints are solved in floats.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "joint_mechanisms.h"

namespace {

using namespace epode_test;

// Twenty-four bodies in a row by balls, the first of them on the world.
Problem hanging(bool held = true)
{
    Problem p;
    for (int i = 0; i < 24; ++i) {
        p.body({Real(i), 0, 0}, 1);
        p.bodies.back().v = {0, 0, Real(i)};
        if (i == 0 && !held) continue;
        p.ball(i, i - 1, {Real(i) - Real(0.5), 0, 0}, Real(1e-6));
        RowBlock& block = p.blocks.back();
        block.form = RowForm::kPoint;
        block.arms = {{Real(-0.5), 0, 0}, i > 0 ? Vec3{Real(0.5), 0, 0} : Vec3{}};
    }
    return p;
}

bool in_floats(Problem p, int sweeps = 20)
{
    Arena arena;
    JointLanes joints(sweeps);
    EXPECT_TRUE(joints.pack(p.system(), arena));
    return joints.in_floats();
}

TEST(JointLanes, are_floats_but_where_digits_could_show)
{
    EXPECT_TRUE(in_floats(hanging()));
    EXPECT_FALSE(in_floats(hanging(), 51));   // more sweeps
    EXPECT_FALSE(in_floats(hanging(false)));  // held by nothing
    Problem p = hanging();
    p.blocks.resize(16);  // few joints
    EXPECT_FALSE(in_floats(p));
    p = hanging();
    p.blocks[3].form = RowForm::kFree;
    EXPECT_FALSE(in_floats(p));
    p = hanging();
    p.numbers[4].lo = 0;  // becomes one of free form
    EXPECT_FALSE(in_floats(p));
    p = hanging();
    p.bodies[5].inv_mass = Real(1.0 / 1100);  // masses
    EXPECT_FALSE(in_floats(p));
    p = hanging();
    p.blocks[7].arms.r1 = {0, 14, 0};  // arms: 12 of gyration squared, seen from two sides
    EXPECT_FALSE(in_floats(p));
    p.blocks[7].arms.r1 = {0, 6, 0};
    EXPECT_TRUE(in_floats(p));
    p.bodies[7].v.x = Real(1e13);  // range
    EXPECT_FALSE(in_floats(p));
    p = hanging();
    p.bodies[7].inv_mass = 0, p.bodies[7].v.x = Real(1e13);  // of what nothing moves, too
    EXPECT_FALSE(in_floats(p));
    p = hanging();
    p.numbers[9].C = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_FALSE(in_floats(p));
}

// Islands that are solved together choose each for itself.
TEST(JointLanes, an_island_chooses_for_itself)
{
    Problem heavy = hanging();
    heavy.bodies[5].inv_mass = Real(1.0 / 1100);
    std::vector<Problem> islands{hanging(), heavy, hanging()};
    Problem together;
    std::vector<SystemPart> parts;
    for (const Problem& p : islands) {
        append(together, p);
        parts.push_back({int(together.bodies.size()), int(together.blocks.size()), 0, 0});
    }
    for (std::size_t i = 0; i < together.blocks.size(); ++i)
        if (RowBlock& block = together.blocks[i]; block.body2 < 0) block.body2 = -1 - int(i / 24);
    const auto visit = [](RowSystem system) {
        Arena arena;
        JointLanes joints(20);
        EXPECT_TRUE(joints.pack(system, arena));
        joints.load(system);
        std::vector<Velocity> out(system.bodies.size() + std::size_t(system.worlds()));
        load_velocities(system, out);
        for (int i = 0; i < 5; ++i) joints.sweep(out, kSweep);
        return out;
    };
    RowSystem system = together.system();
    system.parts = parts;
    const std::vector<Velocity> all = visit(system);
    for (std::size_t i = 0; i < islands.size(); ++i) {
        const std::vector<Velocity> one = visit(islands[i].system());
        for (std::size_t k = 0; k < 24; ++k) EXPECT_EQ(one[k].v.z, all[24 * i + k].v.z) << i << " " << k;
    }
    EXPECT_NE(all[3].v.z, 3);  // they do something
}

}  // namespace
