// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces in joints of what stands or hangs still are those of statics, from the first step on.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

double force_of(const dJointFeedback& feedback) { return length(vec(feedback.f1)); }

// A column of bricks on fixed joints: each bears the weight above it. A chain bears what hangs below.
void load_column(Run& run, bool hangs)
{
    constexpr int kCount = 10;
    constexpr double kMass = 60;
    Stage stage(run);
    std::deque<dJointFeedback> loads;
    dBodyID last = nullptr;
    for (int i = 0; i < kCount; ++i) {
        const dBodyID brick = stage.bar({0.5, 0.25, 0.25}, kMass, {0, 0, (i + 0.5) * (hangs ? -0.25 : 0.25)});
        const dJointID joint =
            hangs ? stage.ball_joint(brick, last, {0, 0, -0.25 * i}) : stage.fix(brick, last);
        dJointSetFeedback(joint, &loads.emplace_back());
        last = brick;
    }
    int steps = 0;
    stage.advance(0.5, [&] {
        for (int i = 0; i < kCount; ++i) {
            const double error =
                100 * std::fabs(force_of(loads[size_t(i)]) / ((kCount - i) * kMass * kGravity) - 1);
            run.record(steps == 0 ? "first" : "early", error);
        }
        ++steps;
    });
}

// A beam of bricks between two walls: its ends bear its weight together.
void load_beam(Run& run)
{
    constexpr int kCount = 11;
    constexpr double kMass = 60;
    Stage stage(run);
    dJointFeedback ends[2];
    dBodyID last = nullptr;
    for (int i = 0; i < kCount; ++i) {
        const dBodyID brick = stage.bar({0.5, 0.25, 0.25}, kMass, {0.5 * i, 0, 3});
        const dJointID joint = stage.fix(brick, last);
        if (i == 0) dJointSetFeedback(joint, &ends[0]);
        last = brick;
    }
    dJointSetFeedback(stage.fix(last, nullptr), &ends[1]);
    int steps = 0;
    stage.advance(0.5, [&] {
        const double borne = ends[0].f1[2] + ends[1].f1[2];
        run.record(steps++ == 0 ? "first" : "early",
                   100 * std::fabs(borne / (kCount * kMass * kGravity) - 1));
    });
}

void load_all(Run& run)
{
    load_column(run, false);
    load_column(run, true);
    load_beam(run);
}

// A wall of bricks on fixed joints is hit by a ball. From half a second after the impact on it swings at most: no force grows much
// from one step to the next, and no brick is fast.
struct Wall {
    static constexpr int kRows = 12, kColumns = 20;
    std::deque<dJointFeedback> loads;
    dBodyID brick[kRows][kColumns];

    explicit Wall(Stage& stage)
    {
        for (int r = 0; r < kRows; ++r)
            for (int i = 0; i < kColumns; ++i)
                brick[r][i] =
                    stage.box({0.5, 0.25, 0.25}, 60, {(i + (r % 2 ? 0.5 : 0)) * 0.5, 0, 0.125 + r * 0.25});
        for (int r = 0; r < kRows; ++r)
            for (int i = 0; i < kColumns; ++i) fix_brick(stage, r, i);
    }
    void fix(Stage& stage, dBodyID a, dBodyID b)
    {
        dJointSetFeedback(stage.fix(a, b), &loads.emplace_back());
    }
    void fix_brick(Stage& stage, int r, int i)
    {
        if (i + 1 < kColumns) fix(stage, brick[r][i], brick[r][i + 1]);
        if (r == 0) fix(stage, brick[0][i], nullptr);
        if (r + 1 == kRows) return;
        fix(stage, brick[r][i], brick[r + 1][i]);
        const int next = r % 2 ? i + 1 : i - 1;
        if (next >= 0 && next < kColumns) fix(stage, brick[r][i], brick[r + 1][next]);
    }
    double largest_force() const
    {
        double largest = 0;
        for (const dJointFeedback& load : loads) largest = std::max(largest, force_of(load));
        return largest;
    }
    double fastest() const
    {
        double fastest = 0;
        for (const auto& row : brick)
            for (dBodyID body : row) fastest = std::max(fastest, length(velocity(body)));
        return fastest;
    }
};

void hit_wall(Run& run)
{
    Stage stage(run);
    stage.floor();
    const Wall wall(stage);
    stage.step();
    const double first = wall.largest_force();
    stage.advance(0.5);
    run.record("start", 100 * std::fabs(first / wall.largest_force() - 1));
    const dBodyID ball = stage.ball(0.4, 200, {5, -2, 1.5});
    set_velocity(ball, {0, 20, 1});
    stage.advance(0.4);
    double last = 0;
    // Short steps take long, and the trouble comes with the bodies' rest, not with time.
    stage.advance(run.setting.step_size == 0 ? 3 : 1, [&] {
        const double force = wall.largest_force();
        run.record("force", force / 1000);
        run.record("jump", force / std::max(last, 1e4));
        run.record("speed", wall.fastest());
        last = force;
    });
}

}  // namespace

extern const Scene kStaticLoads{
    "Joints",
    "static_loads",
    "a column and a chain of ten bricks, a beam of eleven between two walls; half a second",
    {{"first", "forces in the first step, off the weights that they bear", "%", 1},
     {"early", "the same in later steps", "%", 1}},
    &load_all};

extern const Scene kWall{
    "Joints",
    "wall",
    "a ball of 200 kg at 20 m/s hits a wall of 240 bricks on fixed joints; from 0.3 s after the impact on",
    {{"start", "largest force in the first step, off that at rest", "%", 10},
     {"jump", "largest force of a joint over that of the step before, or 10 kN", "1", 1.5},
     {"speed", "speed of the fastest brick", "m/s", 2},
     {"force", "largest force of a joint", "kN", 40}},
    &hit_wall};

}  // namespace epode::trials
