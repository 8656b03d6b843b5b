// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Continuous bodies at hundreds of metres a second do not pass each other, whatever phase of the step they meet in; momentum is kept,
// and impulses are those of the restitution.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

void make_continuous(dBodyID body) { dGeomSetContinuous(dBodyGetFirstGeom(body), dContinuousOn); }

enum class Pair { kBalls, kBoxes, kBallAndSpinningBox };

void shoot(Run& run, Pair pair, double restitution, double offset, int phase)
{
    Stage stage(run, {});
    stage.surface.friction = 0;
    stage.surface.bounce = restitution;
    const Vec left{-10 + 0.37 * phase, offset, 0}, right{10, 0, 0};
    const auto box = [&](Vec at) { return stage.box({0.1, 0.1, 0.1}, 0.1, at); };
    const dBodyID a = pair == Pair::kBoxes ? box(left) : stage.ball(0.05, 0.1, left),
                  b = pair == Pair::kBalls ? stage.ball(0.05, 0.1, right) : box(right);
    set_velocity(a, {200, 0, 0});
    set_velocity(b, {-200, 0, 0}, pair == Pair::kBallAndSpinningBox ? Vec{0, 0, 50} : Vec{});
    make_continuous(a);
    make_continuous(b);
    bool passed = false;
    stage.advance(
        0.2, [&] { passed |= position(a).x > position(b).x && length(position(a) - position(b)) < 0.5; });
    const bool straight = offset == 0 && pair != Pair::kBallAndSpinningBox;
    run.record("passed", straight && (passed || velocity(a).x > velocity(b).x + 1) ? 1 : 0);
    run.record("passed", offset > 0 && std::fabs(velocity(a).x - 200) < 1e-6 ? 1 : 0);
    run.record("momentum", 100 * length(momentum(stage)) / 20);
    if (!straight) return;
    for (dBodyID body : {a, b}) {
        const double v = std::fabs(velocity(body).x);
        restitution > 0 ? run.record("swap", 100 * std::fabs(v / 200 - 1)) : run.record("stop", v);
    }
}

// An upright capsule of 1 kg at 500 m/s and a wall 0.2 m thick, fixed or of 5 kg.
enum class Wall { kBox, kMesh, kMoving };
void hit(Run& run, Wall kind)
{
    Stage stage(run, {});
    stage.surface.friction = 0;
    const Vec size{0.2, 6, 6}, at{10, 0, 0};
    dBodyID wall = nullptr;
    if (kind == Wall::kMoving)
        wall = stage.box(size, 5, at);
    else
        kind == Wall::kBox ? stage.block(size, at) : box_mesh(stage, size, at);
    const dBodyID capsule = stage.capsule(0.5, 1, 1, {-0.5, 0, 0});
    set_velocity(capsule, {500, 0, 0});
    make_continuous(capsule);
    stage.advance(0.3, [&] {
        const double face = wall ? position(wall).x - 0.1 : 9.9;
        run.record("wall", 1000 * (position(capsule).x + 0.5 - face));
    });
    if (!wall) return;
    run.record("momentum", 100 * std::fabs(momentum(stage).x / 500 - 1));
    for (dBodyID body : {wall, capsule}) run.record("common", std::fabs(velocity(body).x - 500 / 6.0));
}

// A ball at 200 m/s meets the edge of a plate of 1 cm that hangs from a hinge.
void hit_plate(Run& run)
{
    for (int phase = 0; phase < 6; ++phase) {
        Stage stage(run, {});
        stage.surface.friction = 0;
        const dBodyID plate = stage.box({0.01, 1, 1}, 1, {0, 0, -0.5});
        stage.hinge(plate, nullptr, {}, kY);
        const dBodyID ball = stage.ball(0.05, 0.1, {-9.5 + 0.37 * phase, 0, -0.97});
        set_velocity(ball, {200, 0, 0});
        make_continuous(ball);
        stage.advance(0.15);
        run.record("plate", std::fabs(velocity(ball).x - 200) < 1e-6 ? 1 : 0);
    }
}

void shoot_all(Run& run)
{
    for (int phase = 0; phase < 10; ++phase) {
        for (Pair pair : {Pair::kBalls, Pair::kBoxes, Pair::kBallAndSpinningBox})
            shoot(run, pair, 0, 0, phase);
        shoot(run, Pair::kBalls, 1, 0, phase);
        shoot(run, Pair::kBalls, 0, 0.03, phase);
    }
    for (Wall kind : {Wall::kBox, Wall::kMesh, Wall::kMoving}) hit(run, kind);
    hit_plate(run);
}

}  // namespace

extern const Scene kFast{
    "Impacts",
    "fast",
    "continuous balls and boxes meet at +-200 m/s in ten phases of a step; a capsule at 500 m/s meets walls "
    "(C20)",
    {{"passed", "pairs that passed each other", "1", 0},
     {"stop", "speed after an impact without restitution", "m/s", 1},
     {"swap", "speed after one with restitution 1, off 200 m/s", "%", 2},
     {"momentum",
      "change of momentum",
      "%",
      1e-7,
      {{Method::kSubsteps | Method::kGame, 1e-4, "Substeps solve contacts in floats (solvers.md)"}}},
     {"wall", "how far the capsule is in the wall", "mm", 10},
     {"common", "speed of capsule and moving wall, off 83.3 m/s", "m/s", 2},
     {"plate", "balls that passed the edge of a hanging plate", "1", 0}},
    &shoot_all};

}  // namespace epode::trials
