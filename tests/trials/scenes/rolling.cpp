// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ball of radius r crosses the seams of a flat floor as if there were none. Without friction it keeps its
// velocity; with friction it slips until it rolls with 5/7 of it, and loses at most mu g h in a step.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

enum class Floor { kBoxes, kMesh, kField };
constexpr double kRadius = 0.1, kSpeed = 5;

void build_floor(Stage& stage, Floor floor)
{
    const Grid grid{-2, -2, 24, 16, 0.25};
    const Height flat = [](double, double) { return 0.0; };
    if (floor == Floor::kMesh) {
        grid_mesh(stage, grid, flat);
    } else if (floor == Floor::kField) {
        height_field(stage, grid, flat);
    } else {
        for (double x : {-1.0, 1.0, 3.0}) stage.block({2, 4, 2}, {x, 0, -1});
    }
}

void cross(Run& run, Floor floor, double friction, double angle)
{
    Stage stage(run);
    stage.surface.friction = friction;
    build_floor(stage, floor);
    const Vec along = angle > 0 ? Vec{std::sin(angle), std::cos(angle), 0} : kX;
    const dBodyID ball = stage.ball(kRadius, 1, {-0.5, angle > 0 ? -1.4 : 0.03, kRadius});
    stage.advance(1);  // into the surface layer
    const double height = position(ball).z;
    dBodyEnable(ball);
    set_velocity(ball, kSpeed * along);
    double last = kSpeed;
    stage.advance(40.0 / 60, [&] {
        const Vec v = velocity(ball);
        const double forward = dot(v, along);
        run.record("hop", 1000 * std::fabs(position(ball).z - height));
        run.record("rise", std::fabs(v.z));
        run.record("jerk", std::fabs(forward - last) - (friction * kGravity * stage.h));
        run.record("aside", length(v - forward * along - v.z * kZ));
        last = forward;
    });
    const double right = friction > 0 ? kSpeed * 5 / 7 : kSpeed;
    run.record(friction > 0 ? "roll" : "glide", 100 * std::fabs(last / right - 1));
    if (friction > 0)
        run.record("roll", 100 * std::fabs(dot(spin(ball), trials::cross(kZ, along)) * kRadius / right - 1));
}

void cross_seams(Run& run)
{
    for (Floor floor : {Floor::kBoxes, Floor::kMesh, Floor::kField}) {
        for (double friction : {0.0, 0.5}) cross(run, floor, friction, 0);
        cross(run, floor, 0, 37 * kPi / 180);
    }
}

}  // namespace

extern const Scene kSeams{
    "Rolling and sliding",
    "seams",
    "a ball at 5 m/s crosses seams of boxes, meshes and height fields, flush, also at 37 degrees (C1)",
    {{"hop", "change of height", "mm", 1},
     {"rise", "vertical speed", "m/s", 0.02},
     {"glide", "speed without friction, off 5 m/s", "%", 0.1},
     {"roll", "speed and spin with friction, off 5/7 of it", "%", 1},
     {"jerk", "change of speed in a step beyond mu g h", "m/s", 1e-3},
     {"aside", "sideways speed", "m/s", 0.01}},
    &cross_seams};

}  // namespace epode::trials
