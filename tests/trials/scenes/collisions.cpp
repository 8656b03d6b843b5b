// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Blows between bodies that move: by closed forms, and by what must never happen.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

// A ball hits an equal one half full: it goes on at 60 degrees with half its speed.
void pot(Run& run)
{
    constexpr double kRadius = 0.0285, kSpeed = 2;
    for (double at : {0.3, 0.308, 0.316}) {  // phases of a step
        Stage stage(run.setting, {});
        stage.toys();
        stage.surface.friction = 0, stage.surface.bounce = 1, stage.surface.bounce_speed = 0.001;
        const dBodyID white = stage.ball(kRadius, 0.17, {-at, kRadius, 0}),
                      red = stage.ball(kRadius, 0.17, {});
        set_velocity(white, {kSpeed, 0, 0});
        const double before = kinetic_energy(stage);
        stage.advance(0.5);
        run.record("direction", degrees_between(velocity(white), {1, std::sqrt(3.0), 0}));
        run.record("direction", degrees_between(velocity(red), {std::sqrt(3.0), -1, 0}));
        const double turning =
            kinetic_energy(white) + kinetic_energy(red) -
            0.085 * (dot(velocity(white), velocity(white)) + dot(velocity(red), velocity(red)));
        run.record("spin", 100 * turning / before);
    }
}

// e = 1, without friction: the impulse at the arm d is J = 2 v / (1/m + 1/M + d^2/I).
void strike_rod(Run& run)
{
    constexpr double kArm = 0.5, kMass = 3, kSpeed = 5, kInertia = kMass * (1.44 + 0.01) / 12;
    Stage stage(run.setting, {});
    stage.surface.friction = 0, stage.surface.bounce = 1, stage.surface.bounce_speed = 0.01;
    const dBodyID rod = stage.box({0.1, 1.2, 0.1}, kMass, {}), ball = stage.ball(0.05, 1, {-0.6, kArm, 0});
    set_velocity(ball, {kSpeed, 0, 0});
    stage.advance(0.3);
    const double impulse = 2 * kSpeed / (1 + 1 / kMass + kArm * kArm / kInertia);
    run.record("rod", 100 * std::fabs(velocity(rod).x * kMass / impulse - 1));
    run.record("rod", 100 * std::fabs(-spin(rod).z * kInertia / (impulse * kArm) - 1));
    run.record("rod", 100 * std::fabs(velocity(ball).x - (kSpeed - impulse)) / kSpeed);
}

double blow_bound(const Setting& setting)
{
    return contains(kCallback, setting.method) ? 10 * 60 * setting.h() : 1;
}

void run_blows(Run& run)
{
    pot(run);
    strike_rod(run);
}

void run_dice(Run& run)
{
    constexpr double kEdge = 0.016, kWall = 0.15;
    Stage stage(run);
    stage.toys();
    stage.surface.friction = 0.4, stage.surface.bounce = 0.3, stage.surface.bounce_speed = 0.2;
    stage.block({0.34, 0.34, 0.02}, {0, 0, -0.01});
    for (int side : {1, -1}) {
        stage.block({0.02, 0.34, 0.3}, {side * (kWall + 0.01), 0, 0.15});
        stage.block({0.34, 0.02, 0.3}, {0, side * (kWall + 0.01), 0.15});
    }
    Lcg random(9);
    std::vector<dBodyID> dice;
    for (int i = 0; i < 27; ++i) {
        const Vec at{(i % 3 - 1) * 0.03, (i / 3 % 3 - 1) * 0.03, 0.08 + 0.03 * (i / 9)};
        dice.push_back(stage.box({kEdge, kEdge, kEdge}, 0.008, at, random.any_turn()));
        const auto rate = [&](double bound) { return random.uniform(-bound, bound); };
        set_velocity(dice.back(), {rate(1), rate(1), -1}, {rate(20), rate(20), rate(20)});
    }
    const double start = energy(stage);
    stage.advance(3, [&] { run.record("gain", 100 * (energy(stage) / start - 1)); });
    int lost = 0;
    for (dBodyID die : dice) {
        const Vec p = position(die);
        lost += std::fabs(p.x) > kWall || std::fabs(p.y) > kWall || p.z < 0;
        if (p.z > 0) run.record("speed", length(velocity(die)));
    }
    run.record("lost", lost);
}

// A bullet of 10 g meets a block that hangs on four rods.
void run_ballistic(Run& run)
{
    constexpr double kBullet = 0.01, kBlock = 2, kSpeed = 300;
    Stage stage(run);
    stage.toys();
    stage.surface.friction = 0.5;
    const dBodyID block = stage.box({0.3, 0.2, 0.2}, kBlock, {});
    for (int i = 0; i < 4; ++i) {
        const dJointID rod = dJointCreateDBall(stage.world, nullptr);
        dJointAttach(rod, block, nullptr);
        const dReal x = i < 2 ? 0.1 : -0.1, y = i % 2 ? 0.08 : -0.08;
        dJointSetDBallAnchor1(rod, x, y, dReal(0.1)), dJointSetDBallAnchor2(rod, x, y, dReal(1.6));
    }
    const dBodyID bullet = stage.ball(0.006, kBullet, {-1.03, 0.001, 0});
    dGeomSetContinuous(dBodyGetFirstGeom(bullet), dContinuousOn);
    set_velocity(bullet, {kSpeed, 0, 0});
    double fastest = 0, highest = 0;
    stage.advance(1.2, [&] {
        fastest = std::max(fastest, velocity(block).x), highest = std::max(highest, position(block).z);
    });
    run.record("speed", 100 * std::fabs(fastest / (kBullet * kSpeed / (kBullet + kBlock)) - 1));
    run.record("height", 100 * std::fabs(2 * kGravity * highest / (fastest * fastest) - 1));
}

// Kinematic rams squeeze three crates by a third of one, and go back.
void run_squeeze(Run& run)
{
    Stage stage(run);
    stage.surface.friction = 0.5;
    stage.floor();
    std::vector<dBodyID> crates;
    for (double x : {-0.52, 0.0, 0.52}) crates.push_back(stage.box({0.5, 0.5, 0.5}, 20, {x, 0, 0.25}));
    const dBodyID rams[] = {stage.box({0.2, 2, 2}, 1, {-1, 0, 1.05}),
                            stage.box({0.2, 2, 2}, 1, {1, 0, 1.05})};
    for (dBodyID ram : rams) dBodySetKinematic(ram);
    const auto go = [&](double speed, double seconds, const char* law) {
        set_velocity(rams[0], {speed, 0, 0}), set_velocity(rams[1], {-speed, 0, 0});
        stage.advance(seconds, [&] {
            for (dBodyID crate : crates) {
                run.record("height", position(crate).z);
                if (law) run.record(law, length(velocity(crate)));
            }
        });
    };
    go(0.2, 1.75, nullptr);
    go(-1, 0.1, nullptr);
    go(-1, 1, "speed");
}

// Blocks that touch fly apart and tumble against each other in empty space.
void run_burst(Run& run)
{
    Stage stage(run.setting, {});
    stage.surface.friction = 0.5, stage.surface.bounce = 0.3;
    Lcg random(14);
    for (int i = 0; i < 8; ++i) {
        const Vec at{i & 1 ? 0.25 : -0.25, i & 2 ? 0.25 : -0.25, i & 4 ? 0.25 : -0.25};
        const dBodyID block = stage.box({0.5, 0.5, 0.5}, 1 + i, at);
        const auto share = [&](double x) { return -x * random.uniform(-2, 6); };
        const auto rate = [&] { return random.uniform(-3, 3); };
        set_velocity(block, {1 + share(at.x), 0.5 + share(at.y), 0.2 + share(at.z)},
                     {rate(), rate(), rate()});
    }
    const Vec p = momentum(stage), L = angular_momentum(stage);
    stage.advance(2);
    run.record("momentum", 100 * length(momentum(stage) - p) / length(p));
    run.record("angular", 100 * length(angular_momentum(stage) - L) / length(L));
}

}  // namespace

extern const Scene kBlows{
    "Impacts",
    "blows",
    "a ball at 2 m/s hits an equal one half full, another a free rod at its end; restitution 1, no friction",
    {{"direction",
      "directions of both balls, off 60 and 30 degrees",
      "degrees",
      2,
      {{kCallback, 60, "Contact joints act once bodies overlap (guide/reports.md)"}}},
     {"spin",
      "energy of their spins, of all",
      "%",
      1e-3,
      {{Method::kSubsteps | Method::kGame, 10,
        "Substeps move the bodies between blow and rebound (solvers.md)"}}},
     {"rod", "velocities of rod and ball, off the closed form", "%", &blow_bound}},
    &run_blows};

extern const Scene kDice{
    "Impacts",
    "dice",
    "27 dice of 16 mm fall at 1 to 2 m/s into a tray with a floor of 20 mm, 3 s",
    {{"lost",
      "dice below or outside",
      "1",
      0,
      {{kCallback, 27, "What is fast and thin is for dGeomSetContinuous (guide/continuous.md)"}}},
     {"gain", "gain of energy", "%", 0.5},
     {"speed", "speed of the fastest in the tray at the end", "m/s", 0.005}},
    &run_dice};

extern const Scene kBallistic{
    "Impacts",
    "ballistic",
    "a continuous bullet of 10 g at 300 m/s hits a block of 2 kg on four rods",
    {{"speed", "speed of the block, off m v / (m + M)", "%", 3}, {"height", "its rise, off the law", "%", 8}},
    &run_ballistic};

extern const Scene kSqueeze{"Impacts",
                            "squeeze",
                            "kinematic rams squeeze three crates of 0.5 m by a third of a crate, and go back",
                            {{"height", "height of a crate at most", "m", 1},
                             {"speed", "speed of a crate after they have gone back", "m/s", 3}},
                            &run_squeeze};

extern const Scene kBurst{"Impacts",
                          "burst",
                          "eight cubes fly apart and tumble against each other in empty space, 2 s",
                          {{"momentum", "change of momentum", "%", 1e-3},
                           {"angular",
                            "change of angular momentum",
                            "%",
                            0.01,
                            {{Method::kSubsteps | Method::kGame, 3,
                              "Substeps keep angular momentum of contacts to first order (solvers.md)"}}}},
                          &run_burst};

}  // namespace epode::trials
