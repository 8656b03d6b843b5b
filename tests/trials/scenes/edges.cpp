// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Nothing falls through an edge of a height field or mesh, however small, nor off it before its border.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

const double kRoot2 = std::sqrt(2.0);

double roof(double x, double) { return 2 - std::fabs(x); }

// Of a point outside the roof z = 2 - |x|: to a face, or to the ridge.
double distance_to_roof(Vec p)
{
    const double above = (p.z - 2 + std::fabs(p.x)) / kRoot2, along = (std::fabs(p.x) - p.z + 2) / kRoot2;
    return along >= 0 || above < 0 ? above : std::hypot(p.x, p.z - 2);
}

struct Fallen {
    dBodyID body;
    double radius;
};

// What is small for its speed is continuous, as the guide recommends.
constexpr double kSpeed = 5;  // m/s

void add_solids(Stage& stage, std::vector<Fallen>& list, double top, bool only_balls)
{
    for (double radius : {0.01, 0.02, 0.05, 0.1, 0.3}) {
        for (double x : {0.0, 0.001, 0.005, 0.02, 0.1}) {
            const Vec at{x, 0.013, top + radius + 0.1};
            const double ball = 1000 * 4 / 3.0 * kPi * radius * radius * radius;
            list.push_back({stage.ball(radius, ball, at), radius});
            if (only_balls) continue;
            for (const Turn& lying : {turn(kX, kPi / 2), turn(kY, kPi / 2)}) {
                list.push_back({stage.capsule(radius, 4 * radius, 4 * ball, at, lying), radius});
                list.push_back({stage.cylinder(radius, 4 * radius, 3 * ball, at, lying), radius});
            }
        }
    }
    for (const Fallen& each : list)
        if (each.radius < kSpeed * stage.h) dGeomSetContinuous(dBodyGetFirstGeom(each.body), dContinuousOn);
}

void fall_on_roof(Run& run, bool field)
{
    Stage stage(run);
    stage.toys();
    stage.bodies_meet = false;
    stage.surface.friction = 0.5;
    const Grid grid{-5, -5, 10, 10, 1};
    field ? height_field(stage, grid, roof) : grid_mesh(stage, grid, roof);
    std::vector<Fallen> list;
    add_solids(stage, list, 2, false);
    stage.advance(1.2, [&] {
        for (const Fallen& each : list) {
            const Vec at = position(each.body);
            if (std::fabs(at.x) > 4.5) continue;
            const double depth = each.radius - distance_to_roof(at);
            run.record("depth", 1000 * (depth - std::max(0.05 * each.radius, 5e-4)));
        }
    });
}

// One sample of height 1 among zeros, the surface between them lower than either way to cut a cell.
void fall_on_peak(Run& run, bool field)
{
    Stage stage(run);
    stage.toys();
    stage.bodies_meet = false;
    stage.surface.friction = 0.5;
    const Height peak = [](double x, double y) { return x == 0 && y == 0 ? 1.0 : 0.0; };
    const Grid grid{-5, -5, 10, 10, 1};
    field ? height_field(stage, grid, peak) : grid_mesh(stage, grid, peak);
    std::vector<Fallen> list;
    add_solids(stage, list, 1, true);
    run.record("through", 0);
    stage.advance(1.2, [&] {
        for (const Fallen& each : list) {
            const Vec at = position(each.body);
            const double low = std::max(0.0, 1 - std::fabs(at.x) - std::fabs(at.y));
            if (std::fabs(at.x) < 4.5 && std::fabs(at.y) < 4.5) run.record("through", at.z < low ? 1 : 0);
        }
    });
}

// Along the outermost row of cells and out over the border.
void roll_out(Run& run, bool field)
{
    Stage stage(run);
    stage.bodies_meet = false;
    const Height level = [](double, double) { return 0.0; };
    const Grid grid{-5, -5, 10, 10, 1};
    field ? height_field(stage, grid, level) : grid_mesh(stage, grid, level);
    std::vector<Fallen> list;
    for (double radius : {0.05, 0.3}) {
        for (double y : {4.6, 4.9}) {
            list.push_back({stage.ball(radius, 1, {3.2, y, radius}), radius});
            set_velocity(list.back().body, {1, 0, 0}, {0, 1 / radius, 0});
        }
    }
    stage.advance(2.2, [&] {
        for (const Fallen& each : list) {
            const Vec at = position(each.body);
            if (at.x < 5) run.record("through", at.z < 0.9 * each.radius ? 1 : 0);
        }
    });
}

void fall_on_edges(Run& run)
{
    for (bool field : {true, false}) {
        fall_on_roof(run, field);
        fall_on_peak(run, field);
        roll_out(run, field);
    }
}

// What falls 0.1 m is found so deep in a slope of 45 degrees.
double impact_depth(const Setting& setting) { return 1000 * 1.6 / kRoot2 * setting.h() + 1; }
// A quarter of the radius less a twentieth, of the largest that is continuous.
double continuous_depth(const Setting& setting)
{
    return setting.step_size == 0 ? 0.2 * 50 : setting.step_size == 1 ? 0.2 * 20 : 0;
}

}  // namespace

extern const Scene kEdges{
    "Surfaces",
    "edges",
    "balls, capsules and cylinders of 1 cm to 0.3 m fall on a ridge and a peak of fields and meshes (C7)",
    {{"depth",
      "depth beyond 0.5 mm or a twentieth of the radius",
      "mm",
      0,
      {{kCallback, &impact_depth, "Contact joints act once bodies overlap (guide/reports.md)"},
       {kAll, &continuous_depth,
        "Continuous bodies stop an eighth of their thickness deep (guide/continuous.md)"}}},
     {"through", "balls that fell through a peak, or before they left the border", "1", 0}},
    &fall_on_edges,
    false,
    true};

}  // namespace epode::trials
