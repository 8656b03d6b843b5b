// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints of every form between bodies, made without a world, and what lanes of a kind answer.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "solve/joints/joint_lanes.h"
#include "systems.h"

namespace epode_test {

inline constexpr JointSweep kSweep{Real(1.2), false};

// Do these lanes compute in floats?
template <typename L>
inline constexpr bool kCoarse = sizeof(typename L::Number) == sizeof(float);

inline std::vector<int> joints_of(const RowSystem& system)
{
    std::vector<int> out;
    for (std::size_t i = 0; i < system.blocks.size(); ++i)
        if (!system.blocks[i].contact) out.push_back(int(i));
    return out;
}

// A joint of the form, some of whose rows behind the third are bounded; with `loose`, bounds also before.
inline void add_joint(Problem& p, Dice& dice, int body1, int body2, RowForm form, bool loose)
{
    const Vec3 at = p.places[std::size_t(body1)] + dice.vec(1);
    Vec3 d[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (form == RowForm::kTurned) {
        d[0] = dice.direction();
        plane_space(d[0], d[1], d[2]);
    }
    std::vector<Row> of;
    const int count = form == RowForm::kFree ? 1 + dice.below(6) : 3 + dice.below(4);
    for (int i = 0; i < count; ++i) {
        Row row;
        if (form == RowForm::kFree) {
            row.lin1 = dice.vec(1), row.ang1 = dice.vec(1);
            if (body2 >= 0) row.lin2 = dice.vec(1), row.ang2 = dice.vec(1);
            row.cfm = Real(1e-4);
        } else if (i < 3) {
            row = p.point_row(body1, body2, at, d[i], Real(0.2), Real(1e-6));
        } else {
            row.ang1 = dice.direction(), row.cfm = Real(1e-6);
            if (body2 >= 0) row.ang2 = -row.ang1;
        }
        row.erp = Real(0.2), row.error = dice.real(Real(-0.02), Real(0.02)), row.speed = dice.real(-1, 1);
        if ((i >= 3 || loose) && dice.below(2) == 0) {
            row.kind = RowKind::kLimit;
            row.lo = dice.below(2) ? 0 : -dice.real(0, 50), row.hi = dice.below(2) ? kInf : dice.real(0, 50);
        }
        of.push_back(row);
    }
    p.block(body1, body2, false, of);
    p.blocks.back().form = form;
    p.blocks.back().arms.r1 = at - p.places[std::size_t(body1)];
    p.blocks.back().arms.r2 = body2 >= 0 ? at - p.places[std::size_t(body2)] : Vec3{};
    for (int i = 0; i < count; ++i) p.numbers[p.numbers.size() - 1 - std::size_t(i)].p = dice.real(-1, 1);
}

// Bodies, some of which nothing moves, and joints of every form between them; `star`: all at the first one.
inline Problem mechanism(std::uint64_t seed, int bodies, int joints, bool star = false)
{
    Dice dice(seed);
    Problem p;
    for (int i = 0; i < bodies; ++i) {
        const Vec3 sides{dice.real(Real(.5), 2), dice.real(Real(.5), 2), dice.real(Real(.5), 2)};
        p.body(dice.vec(3), i % 9 == 8 ? Real(0) : dice.real(Real(.2), 3), sides);
        p.bodies.back().v = dice.vec(1), p.bodies.back().w = dice.vec(1);
    }
    for (int i = 0; i < joints; ++i) {
        const int a = star ? 0 : dice.below(bodies);
        int b = star ? 1 + i % (bodies - 1) : dice.below(bodies + 1) - 1;
        if (a == b) b = -1;
        add_joint(p, dice, a, b, RowForm(i % 3), i % 7 == 0);
    }
    return p;
}

struct Answer {
    std::vector<Velocity> velocities;
    std::vector<RowNumbers> numbers;
};

template <typename L>
Answer solve(const JointKernels& kernels, Problem p, int sweeps, JointSweep how = kSweep)
{
    Arena arena;
    const RowSystem system = p.system();
    JointSetOf<L> set(kernels);
    EXPECT_TRUE(set.pack(system, joints_of(system), arena));
    set.load(system);
    Answer out;
    out.velocities.resize(p.bodies.size() + 1);
    load_velocities(system, out.velocities);
    set.apply_impulses(out.velocities);
    for (int i = 0; i < sweeps; ++i) set.sweep(out.velocities, how);
    set.store_impulses(p.numbers);
    out.numbers = p.numbers;
    return out;
}

inline void expect_same(const Answer& a, const Answer& b, std::size_t body0 = 0, std::size_t row0 = 0)
{
    for (std::size_t i = 0; i + 1 < a.velocities.size(); ++i) {
        EXPECT_EQ(std::memcmp(&a.velocities[i].v, &b.velocities[body0 + i].v, sizeof(Vec3)), 0)
            << "body " << i;
        EXPECT_EQ(std::memcmp(&a.velocities[i].w, &b.velocities[body0 + i].w, sizeof(Vec3)), 0)
            << "body " << i;
    }
    for (std::size_t i = 0; i < a.numbers.size(); ++i)
        EXPECT_EQ(std::memcmp(&a.numbers[i].p, &b.numbers[row0 + i].p, sizeof(Real)), 0) << "row " << i;
}

// `more`, packed behind `together`.
inline void append(Problem& together, const Problem& more)
{
    const int body0 = int(together.bodies.size()), row0 = int(together.rows.size());
    together.bodies.insert(together.bodies.end(), more.bodies.begin(), more.bodies.end());
    together.rows.insert(together.rows.end(), more.rows.begin(), more.rows.end());
    together.numbers.insert(together.numbers.end(), more.numbers.begin(), more.numbers.end());
    for (RowBlock block : more.blocks) {
        block.first += row0, block.body1 += body0;
        if (block.body2 >= 0) block.body2 += body0;
        together.blocks.push_back(block);
    }
}

}  // namespace epode_test
