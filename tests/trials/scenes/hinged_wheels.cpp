// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What rolls freely on a level floor goes straight on at its speed, however far its wheels turn in a step.
#include "measure.h"

namespace epode::trials {

namespace {

constexpr double kWheel = 0.3;
constexpr Turn kLying{0.7071067811865476, 0.7071067811865476, 0, 0};  // along y

dBodyID add_cart(Stage& stage, double x, double mass, double speed)
{
    const dBodyID cart = stage.box({2, 1, 0.4}, mass, {x, 0, 0.5});
    set_velocity(cart, {speed, 0, 0});
    for (int i = 0; i < 4; ++i) {
        const Vec at{x + (i & 1 ? 0.7 : -0.7), i & 2 ? 0.65 : -0.65, kWheel};
        const dBodyID wheel = stage.cylinder(kWheel, 0.2, 15, at, kLying);
        set_velocity(wheel, {speed, 0, 0}, {0, speed / kWheel, 0});
        stage.hinge(cart, wheel, at, kY);
    }
    return cart;
}

void roll(Run& run, double speed)
{
    Stage stage(run);
    stage.floor();
    const dBodyID carts[] = {add_cart(stage, 0, 500, speed), add_cart(stage, -3, 300, speed)};
    stage.ball_joint(carts[0], carts[1], {-1.5, 0, 0.5});
    stage.advance(5, [&] {
        for (dBodyID cart : carts) {
            run.record("aside", 1000 * std::fabs(position(cart).y));
            run.record("height", 1000 * std::fabs(position(cart).z - 0.5));
            run.record("speed", 100 * std::fabs(velocity(cart).x / speed - 1));
        }
    });
}

void run_hinged_wheels(Run& run)
{
    for (double speed : {5.0, 20.0, 40.0}) roll(run, speed);
}

}  // namespace

extern const Scene kHingedWheels{
    "Machines",
    "hinged_wheels",
    "a cart with a trailer, both on four wheels on plain hinges, rolls at 5, 20 and 40 m/s, 5 s",
    {{"aside", "way off its line", "mm", 1},
     {"height", "height of the carts, off", "mm", 3},
     {"speed", "speed, off", "%", 0.1}},
    &run_hinged_wheels};

}  // namespace epode::trials
