// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What falls flat on a level floor stays upright: by symmetry nothing moves it sideways.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

struct Solid {
    double radius, length;  // radius 0: a plate of 0.5 m with this thickness
};

struct Landing {
    dBodyID body;
    Vec start;
    double height;
    bool flat;
};

// The horizontal speed of the centre where the solid falls on a single point of its rim, which then does not move: w = v r / (k^2 + r^2 +
// l^2/4), of which the height of the centre makes w l/2. Two points of contact give less.
constexpr double kDrop = 0.24;
double single_edge(const Solid& solid)
{
    const double side = solid.radius == 0 ? 0.25 : solid.radius, l = solid.length;
    const double gyration = (solid.radius == 0 ? side * side / 3 : side * side / 4) + l * l / 12;
    return std::sqrt(2 * kGravity * kDrop) * side / (gyration + side * side + l * l / 4) * l / 2;
}

dBodyID add(Stage& stage, const Solid& solid, Vec at, Turn q)
{
    if (solid.radius == 0) return stage.box({0.5, 0.5, solid.length}, 1000 * 0.25 * solid.length, at, q);
    return stage.cylinder(solid.radius, solid.length, 1000 * kPi * solid.radius * solid.radius * solid.length,
                          at, q);
}

void judge_rest(Run& run, const Stage& stage, const Landing& landing)
{
    const Vec now = position(landing.body);
    run.record(landing.flat ? "upright" : "stands",
               degrees_between(rotate(orientation(landing.body), kZ), kZ));
    if (!landing.flat) return;
    run.record("height", 1000 * std::max(now.z - landing.height, landing.height - stage.layer() - now.z));
    run.record("moved", 1000 * across(now - landing.start));
    run.record("speed", length(velocity(landing.body)));
    run.record("speed", length(spin(landing.body)));
}

// At places of the floor, flat and tilted by up to a thousandth.
void land(Run& run, const Solid& solid)
{
    Stage stage(run);
    stage.surface.friction = 1;
    stage.bodies_meet = false;
    stage.block({4, 4, 0.6}, {0, 0, -0.3});
    std::vector<Landing> landings;
    for (const Vec& place :
         {Vec{0, 0, 0}, Vec{0, 0.2, 0}, Vec{-0.2, 0.5, 0}, Vec{0.15, -0.375, 0}, Vec{0.05, 0.125, 0}}) {
        for (double tilt : {0.0, 1e-6, 1e-3}) {
            const Vec at = place + (solid.length / 2 + kDrop) * kZ;
            landings.push_back(
                {add(stage, solid, at, turn({0.6, 0.8, 0}, tilt)), place, solid.length / 2, tilt <= 1e-6});
        }
    }
    stage.advance(2, [&] {
        for (const Landing& landing : landings)
            landing.flat ? run.record("sideways", across(velocity(landing.body)))
                         : run.record("rocked", across(velocity(landing.body)) / single_edge(solid));
    });
    stage.advance(1);
    for (const Landing& landing : landings) judge_rest(run, stage, landing);
}

void land_all(Run& run)
{
    for (const Solid& solid : {Solid{0.06, 0.12}, Solid{0.1, 0.6}, Solid{0, 0.05}}) land(run, solid);
}

}  // namespace

extern const Scene kFlatLandings{
    "Impacts",
    "flat_landings",
    "cylinders, pillars and plates fall 0.24 m on their faces at five places, tilted by 0, 1e-6 and 1e-3 rad "
    "(C8)",
    {{"sideways", "horizontal speed, tilted by 1e-6 at most", "m/s", 0.05},
     {"rocked", "the same, tilted by 1e-3, over that of an impact on one point of the rim", "1", 1.05},
     {"stands", "tilt after 3 s, tilted by 1e-3 at first", "degrees", 5},
     {"upright", "tilt after 3 s, tilted by 1e-6 at most", "degrees", 0.2},
     {"height", "height after 3 s, tilted by 1e-6 at most", "mm", 0.5},
     {"moved", "way along the floor, the same", "mm", 1},
     {"speed", "speed after 3 s, the same", "m/s", 1e-3}},
    &land_all};

}  // namespace epode::trials
