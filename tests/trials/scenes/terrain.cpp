// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A slope is a slope, whether of a height field, a mesh or a box, and a hole is a hole, whether its triangles are missing or rejected by
// a callback.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

enum class Ground { kField, kMesh, kRough, kBox };
const double kSlope = 20 * kPi / 180;
const Turn kTilt = turn(kY, kSlope);
const Vec kDown = rotate(kTilt, kX), kUp = rotate(kTilt, kZ);

void build_slope(Stage& stage, Ground kind)
{
    Lcg random(11);
    const Grid grid{-4, -6, 40, 24, 0.5};
    const Height slope = [&](double x, double) {
        return -std::tan(kSlope) * x + (kind == Ground::kRough ? random.uniform(0, 1e-6) : 0);
    };
    if (kind == Ground::kField)
        height_field(stage, grid, slope);
    else if (kind == Ground::kBox)
        stage.block({60, 12, 1}, -0.5 * kUp, kTilt);
    else
        grid_mesh(stage, grid, slope);
}

// A chassis on four wheels whose hinges are held by motors.
dBodyID add_cart(Stage& stage, double y)
{
    const Vec centre = 0.2 * kUp + y * kY;
    const dBodyID chassis = stage.box({0.6, 0.4, 0.1}, 5, centre, kTilt);
    for (int i = 0; i < 4; ++i) {
        const Vec at = 0.12 * kUp + y * kY + (i < 2 ? 0.25 : -0.25) * kDown + (i % 2 ? 0.24 : -0.24) * kY;
        const dBodyID wheel = stage.cylinder(0.12, 0.05, 0.5, at, kTilt * turn(kX, kPi / 2));
        const dJointID hinge = stage.hinge(chassis, wheel, at, kY);
        dJointSetHingeParam(hinge, dParamFMax, 20);
    }
    return chassis;
}

void lie_on_slope(Run& run, Ground kind, double friction)
{
    Stage stage(run);
    stage.surface.friction = friction;
    build_slope(stage, kind);
    const dBodyID cube = stage.box({0.4, 0.4, 0.4}, 2, 0.2 * kUp - 3 * kY, kTilt),
                  can = stage.cylinder(0.2, 0.3, 2, 0.15 * kUp - 1.5 * kY, kTilt),
                  ball = stage.ball(0.2, 2, 0.2 * kUp);
    const dBodyID cart = friction > 0.5 ? add_cart(stage, 2) : nullptr;
    stage.advance(0.5);
    const std::vector<dBodyID> still = cart ? std::vector{cube, can, cart} : std::vector{cube, can};
    std::vector<Vec> start;
    for (dBodyID body : still) start.push_back(position(body));
    const auto speed = [](dBodyID body) { return dot(velocity(body), kDown); };
    const double first[] = {speed(cube), speed(can), speed(ball)}, seconds = 2;
    stage.advance(seconds);
    const double time = stage.steps_in(seconds) * stage.h;
    const auto judge = [&](const char* law, dBodyID body, double from, double right) {
        run.record(law, 100 * std::fabs((speed(body) - from) / time / right - 1));
    };
    if (!cart) {
        const double right = kGravity * (std::sin(kSlope) - friction * std::cos(kSlope));
        judge("slide", cube, first[0], right);
        judge("slide", can, first[1], right);
        return;
    }
    judge("roll", ball, first[2], kGravity * std::sin(kSlope) * 5 / 7);
    for (size_t i = 0; i < still.size(); ++i)
        run.record("stay", 1000 * length(position(still[i]) - start[i]));
}

void lie_on_slopes(Run& run)
{
    for (Ground kind : {Ground::kField, Ground::kMesh, Ground::kRough, Ground::kBox})
        for (double friction : {0.8, 0.2}) lie_on_slope(run, kind, friction);
}

// A ball larger than a hole of 0.5 m rests on its edges, whether the triangles are missing or a callback rejects them.
int reject_middle(dGeomID, dGeomID, int triangle) { return triangle / 2 != 12; }

void lie_on_hole(Run& run, bool by_callback)
{
    constexpr double kRadius = 0.6, kHalf = 0.25;
    Stage stage(run);
    stage.surface.friction = 1;
    std::vector<Vec> corners;
    std::vector<dTriIndex> indices;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) corners.push_back({(i - 2.5) * 0.5, (j - 2.5) * 0.5, 0});
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            const dTriIndex a = dTriIndex(6 * i + j);
            if (by_callback || 5 * i + j != 12)
                indices.insert(indices.end(), {a, a + 6, a + 1, a + 1, a + 6, a + 7});
        }
    }
    const dGeomID floor = mesh(stage, corners, indices);
    if (by_callback) dGeomTriMeshSetCallback(floor, &reject_middle);
    const dBodyID ball = stage.ball(kRadius, 1, {0.02, 0.01, 0.7});
    stage.advance(4);
    const double right = std::sqrt(kRadius * kRadius - kHalf * kHalf), off = position(ball).z - right;
    // A depth d at an edge whose normal leans lets the ball down by d r / z.
    run.record(by_callback ? "rejected" : "missing",
               1000 * std::max(off, -off - stage.layer() * kRadius / right));
}

void lie_on_holes(Run& run)
{
    for (bool by_callback : {true, false}) lie_on_hole(run, by_callback);
}

}  // namespace

extern const Scene kSlopes{
    "Surfaces",
    "slopes",
    "cubes, cylinders, balls and carts on a slope of 20 degrees of field, mesh, rough mesh and box (C13)",
    {{"stay", "way with mu 0.8 in 2 s", "mm", 2},
     {"roll", "acceleration of the ball, off 5/7 g sin 20", "%", 2},
     {"slide", "acceleration with mu 0.2, off g (sin 20 - mu cos 20)", "%", 2}},
    &lie_on_slopes};

extern const Scene kHole{
    "Surfaces",
    "hole",
    "a ball of 0.6 m lies on a hole of 0.5 m in a mesh, 4 s",
    {{"rejected", "height where a callback rejects the triangles, off the closed form", "mm", 1},
     {"missing",
      "height where the triangles are missing",
      "mm",
      1,
      {{set_of(Method::kSubsteps), 1.5, "What settles keeps a millimetre (guide/sleeping.md)"}}}},
    &lie_on_holes};

}  // namespace epode::trials
