// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Surfaces that move drag what lies on them until it moves with them, by Coulomb friction; a belt at rest holds like a ramp.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

// Two belts along x side by side; sideways: their velocities across it.
void carry(Run& run, double sideways_left, double sideways_right)
{
    Stage stage(run);
    stage.surface.friction = 0.6;
    for (double side : {1.0, -1.0}) {
        stage.surface.surface_velocity[0] = 1;
        stage.surface.surface_velocity[1] = side > 0 ? sideways_left : sideways_right;
        stage.block({20, 1, 0.2}, {5, 0.5 * side, -0.1});
    }
    stage.surface.surface_velocity[0] = stage.surface.surface_velocity[1] = 0;
    const dBodyID parcel = stage.box({0.6, 0.5, 0.3}, 5, {0, 0, 0.15});
    stage.advance(2);
    const bool equal = sideways_left == sideways_right;
    stage.advance(1, [&] {
        run.record("speed", 100 * std::fabs(velocity(parcel).x - 1));
        if (equal) {
            run.record("speed", 100 * std::fabs(velocity(parcel).y / sideways_left - 1));
            return;
        }
        const Vec ahead = rotate(orientation(parcel), kX);
        run.record("aside", 1000 * std::fabs(position(parcel).y));
        run.record("yaw", degrees(std::fabs(std::atan2(ahead.y, ahead.x))));
    });
}

// A plain ramp, a belt at rest, a belt that runs uphill.
void climb(Run& run, double friction, double belt)
{
    constexpr double kSlope = 30 * kPi / 180;
    const Turn tilt = turn(kY, kSlope);
    const Vec down = rotate(tilt, kX), up = rotate(tilt, kZ);
    Stage stage(run);
    stage.surface.friction = friction;
    stage.surface.surface_velocity[0] = -belt;
    stage.block({40, 2, 1}, -0.5 * up, tilt);
    stage.surface.surface_velocity[0] = 0;
    const dBodyID box = stage.box({0.4, 0.4, 0.4}, 10, 0.2 * up, tilt);
    stage.advance(belt > 0 ? 6 : 1);  // it gains 0.1 m/s in a second
    const Vec start = position(box);
    const double first = dot(velocity(box), down);
    stage.advance(2);
    const double last = dot(velocity(box), down), time = stage.steps_in(2) * stage.h;
    const double right = kGravity * (std::sin(kSlope) - friction * std::cos(kSlope));
    if (right > 0)
        run.record("slide", 100 * std::fabs((last - first) / time / right - 1));
    else if (belt > 0)
        run.record("climb", 100 * std::fabs(last / -belt - 1));
    else
        run.record("hold", 1000 * length(position(box) - start));
}

void run_belts(Run& run)
{
    carry(run, -0.3, 0.3);
    carry(run, 0.3, 0.3);
    for (double friction : {0.589, 0.554})
        for (double belt : {0.0, 0.5}) climb(run, friction, belt);
}

}  // namespace

extern const Scene kBelts{
    "Rolling and sliding",
    "belts",
    "a parcel on two belts that drift towards each other; boxes on ramps of 30 degrees that are belts (C21)",
    {{"speed", "speed of the parcel, off the belt's", "%", 1},
     {"aside", "way of the parcel off the seam", "mm", 10},
     {"yaw", "its turn", "degrees", 1},
     {"hold", "way in 2 s on a belt at rest, mu 0.589", "mm", 1},
     {"climb", "speed on a belt that runs uphill at 0.5 m/s", "%", 1},
     {"slide", "acceleration with mu 0.554, off the law", "%", 5}},
    &run_belts};

}  // namespace epode::trials
