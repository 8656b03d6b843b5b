// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Coulomb friction with a coefficient mu. On a slope of angle s a block slides with g (sin s - mu cos s) or stays where mu > tan s; a
// horizontal force F moves it with F/m - mu g or not at all; on a level floor it slides v^2 / (2 mu g), in any direction.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kSlope = 30 * kPi / 180;

double acceleration_along(Stage& stage, dBodyID body, Vec along, double from, double seconds)
{
    stage.advance(from);
    const double before = dot(velocity(body), along);
    stage.advance(seconds);
    return (dot(velocity(body), along) - before) / (stage.steps_in(seconds) * stage.h);
}

void slide_on_ramp(Run& run)
{
    const Turn tilt = turn(kY, kSlope);
    const Vec down = rotate(tilt, kX), up = rotate(tilt, kZ);
    for (double friction : {0.0, 0.2, 0.5, 0.7}) {
        Stage stage(run);
        stage.surface.friction = 1;
        stage.block({40, 2, 1}, -0.5 * up, tilt);
        stage.surface.friction = friction;
        stage.surface.friction_rule = dCombineMinimum;
        const dBodyID cube = stage.box({0.3, 0.3, 0.3}, 2, 0.15 * up - 8 * down, tilt);
        const Vec start = position(cube);
        const double right = kGravity * (std::sin(kSlope) - friction * std::cos(kSlope));
        if (right > 0) {
            const double found = acceleration_along(stage, cube, down, 0.3, 1.2);
            run.record("slide", 100 * std::fabs(found / right - 1));
        } else {
            stage.advance(0.5);
            const Vec settled = position(cube);
            stage.advance(4.5);
            run.record("stay", 1000 * length(position(cube) - settled));
        }
        run.record("aside", 1000 * std::fabs(position(cube).y - start.y));
    }
}

void roll_out(Run& run)
{
    constexpr double kRadius = 0.2, kSpeed = 2;
    for (double arm : {0.0, 0.002, 0.01}) {
        Stage stage(run);
        stage.surface.friction = 1;
        stage.surface.rolling_friction = arm;
        stage.floor();
        const dBodyID ball = stage.ball(kRadius, 3, {0, 0, kRadius});
        stage.advance(0.5);
        set_velocity(ball, {kSpeed, 0, 0}, {0, kSpeed / kRadius, 0});
        dBodyEnable(ball);
        const double right = 5.0 / 7 * arm * kGravity / kRadius;
        const double found = -acceleration_along(stage, ball, kX, 0.1, 2);
        if (right > 0)
            run.record("deceleration", 100 * std::fabs(found / right - 1));
        else
            run.record("free", std::fabs(found));
        if (arm < 0.01) continue;
        stage.advance(5);
        run.record("way", 100 * std::fabs(position(ball).x / (kSpeed * kSpeed / 2 / right) - 1));
        run.record("rest", length(velocity(ball)));
    }
}

// A cube under a horizontal force, its limit 4.905 N.
void draw_cube(Run& run)
{
    for (double force : {4.85, 4.9, 5.0, 5.5}) {
        for (double angle : {0.0, 10.0, 30.0, 45.0, 77.0}) {
            Stage stage(run);
            stage.surface.friction = 0.5;
            stage.floor();
            const dBodyID cube = stage.box({0.4, 0.4, 0.4}, 1, {0, 0, 0.2});
            stage.advance(1);
            const Vec along = rotate(turn(kZ, angle * kPi / 180), kX), start = position(cube);
            for (int i = stage.steps_in(5); i-- > 0;) {
                dBodyEnable(cube);
                dBodyAddForce(cube, force * along.x, force * along.y, 0);
                stage.step();
            }
            const Vec way = position(cube) - start;
            const double right = 12.5 * std::max(force - 4.905, 0.0);
            if (right == 0)
                run.record("held", 1000 * across(way));
            else
                run.record("way", 100 * std::fabs(dot(way, along) / right - 1));
            if (right > 0) run.record("aside", 100 * across(way - dot(way, along) * along) / right);
        }
    }
}

// Slabs slide out in several directions, one spins out: with a quarter of the weight at each corner of a square of side a the torque is
// mu m g a / sqrt 2 and the moment m a^2 / 6.
void slide_out(Run& run, double friction, bool mixed)
{
    constexpr double kSpeed = 3, kSide = 1, kRate = 6;
    const double right = kSpeed * kSpeed / (2 * friction * kGravity);
    for (double angle : {0.0, 15.0, 22.5, 40.0, 45.0, 67.5}) {
        Stage stage(run);
        stage.surface.friction = friction;
        stage.floor();
        const dBodyID slab = stage.box({kSide, kSide, 0.2}, 1, {0, 0, 0.1});
        const Vec along = rotate(turn(kZ, angle * kPi / 180), kX);
        stage.advance(0.2);
        const Vec start = position(slab);
        set_velocity(slab, kSpeed * along);
        const dJointGroupID group = dJointGroupCreate(0);
        stage.advance(1.5, [&] {
            dJointGroupEmpty(group);
            if (!mixed) return;
            // A contact joint of the program that holds nothing: it lies ahead of the slab, without friction.
            dContact contact = {};
            contact.surface.mode = dContactApprox1;
            const dReal* at = dBodyGetPosition(slab);
            std::copy(at, at + 3, contact.geom.pos);
            contact.geom.normal[0] = along.x, contact.geom.normal[1] = along.y;
            dJointAttach(dJointCreateContact(stage.world, group, &contact), slab, nullptr);
        });
        const Vec way = position(slab) - start;
        run.record(mixed ? "mixed" : "way", 100 * std::fabs(length(way) / right - 1));
        run.record(mixed ? "mixed_aside" : "aside", 100 * across(way - dot(way, along) * along) / right);
        dJointGroupDestroy(group);
    }
    if (mixed) return;
    Stage stage(run);
    stage.surface.friction = friction;
    stage.floor();
    const dBodyID slab = stage.box({kSide, kSide, 0.2}, 1, {0, 0, 0.1});
    stage.advance(0.2);
    set_velocity(slab, {}, {0, 0, kRate});
    double turned = 0;
    stage.advance(2, [&] { turned += spin(slab).z * stage.h; });
    const double slowing = friction * kGravity * 6 / (std::sqrt(2.0) * kSide);
    run.record("yaw", 100 * std::fabs(turned / (kRate * kRate / (2 * slowing)) - 1));
}

void slide_out_all(Run& run)
{
    slide_out(run, 0.4, false);
    slide_out(run, 0.4, true);
}

// A step of length h that ends with a speed of 0 is off by half of it.
double way_bound(const Setting& setting) { return 0.5 + 100 * 0.4 * kGravity * setting.h() / 3; }

constexpr const char* kPyramidReason = "The bound of friction is a pyramid in ODE's way (guide/contacts.md)";

}  // namespace

extern const Scene kRamp{"Rolling and sliding",
                         "ramp",
                         "cubes with mu 0, 0.2, 0.5 and 0.7 on a slope of 30 degrees (C11)",
                         {{"slide", "acceleration, off g (sin 30 - mu cos 30)", "%", 1},
                          {"stay", "way with mu 0.7 in 4.5 s", "mm", 1},
                          {"aside", "way aside", "mm", 1}},
                         &slide_on_ramp};

extern const Scene kRollOut{"Rolling and sliding",
                            "roll_out",
                            "balls at 2 m/s with rolling friction 0, 2 and 10 mm (C11)",
                            {{"deceleration", "deceleration, off 5/7 rho g / r", "%", 3},
                             {"free", "deceleration without rolling friction", "m/s^2", 1e-3},
                             {"way", "way with 10 mm, off 5.71 m", "%", 3},
                             {"rest", "speed at its end", "m/s", 1e-3}},
                            &roll_out};

extern const Scene kDrawnCube{
    "Rolling and sliding",
    "drawn_cube",
    "a cube under horizontal forces of 4.85 to 5.5 N in five directions, its limit 4.905 N (C12)",
    {{"held", "way in 5 s under 4.85 and 4.90 N", "mm", 1},
     {"way", "way in 5 s under 5.00 and 5.50 N, off the law", "%", 3, {{kCallback, 100, kPyramidReason}}},
     {"aside", "way aside", "%", 1, {{kCallback, 100, kPyramidReason}}}},
    &draw_cube};

extern const Scene kSlideOut{
    "Rolling and sliding",
    "slide_out",
    "slabs at 3 m/s slide out in six directions, mu 0.4; one spins out at 6 rad/s; then with a contact joint "
    "in the island",
    {{"way", "way, off v^2 / (2 mu g)", "%", &way_bound, {{kCallback, 35, kPyramidReason}}},
     {"aside", "way aside", "%", 0.5, {{kCallback, 20, kPyramidReason}}},
     {"yaw",
      "turn of the slab that spins, off that with its weight at the corners",
      "%",
      5,
      {{kCallback, 30, kPyramidReason}}},
     {"mixed", "way with a contact joint, off the law", "%", &way_bound, {{kCallback, 35, kPyramidReason}}},
     {"mixed_aside", "way aside with it", "%", 0.5, {{kCallback, 20, kPyramidReason}}}},
    &slide_out_all};

}  // namespace epode::trials
