// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Structures that lie loose and stand by friction, by symmetry, or by what is below them.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

// The longest way of a body from `settle` on, mm.
void stand(Run& run, Stage& stage, double settle, double seconds, const char* law)
{
    stage.advance(settle);
    const std::vector<dBodyID> bodies = bodies_of(stage.world);
    std::vector<Vec> start;
    for (dBodyID body : bodies) start.push_back(position(body));
    stage.advance(seconds, [&] {
        for (size_t i = 0; i < bodies.size(); ++i)
            run.record(law, 1000 * length(position(bodies[i]) - start[i]));
    });
}

dGeomID box_of_triangles(Stage& stage, double edge)
{
    const dGeomID geom = box_mesh(stage, {edge, edge, edge}, {});
    return geom;
}

// Sides flush, a millionth of a radian off, and a tenth.
void run_mesh_crates(Run& run)
{
    constexpr double kEdge = 0.5;
    for (double yaw : {0.0, 1e-6, 0.1}) {
        Stage stage(run);
        stage.surface.friction = 0.5;
        grid_mesh(stage, {-2, -2, 8, 8, 0.5}, [](double, double) { return 0; });
        dMass mass;
        dMassSetBoxTotal(&mass, 10, kEdge, kEdge, kEdge);
        dBodyID top = nullptr;
        for (int i = 0; i < 3; ++i)
            top = stage.body(box_of_triangles(stage, kEdge), mass, {0, 0, (i + 0.5) * kEdge},
                             turn(kZ, yaw * i));
        stand(run, stage, 1, 2, "way");
        run.record("height",
                   1000 * std::max(0.0, std::fabs(position(top).z - 2.5 * kEdge) - 3 * stage.layer()));
    }
}

// Stones of a semicircle between two that are fixed.
void run_arch(Run& run)
{
    constexpr double kInner = 2, kOuter = 2.5, kHalfWidth = 0.25;
    constexpr int kStones = 11;
    Stage stage(run);
    stage.surface.friction = 0.7;
    for (int i = 0; i < kStones; ++i) {
        const double from = kPi * i / kStones, to = kPi * (i + 1) / kStones, middle = (from + to) / 2;
        const Vec at = (kInner + kOuter) / 2 * Vec{std::cos(middle), 0, std::sin(middle)};
        std::vector<dReal> points;
        for (double angle : {from, to})
            for (double radius : {kInner, kOuter})
                for (double y : {-kHalfWidth, kHalfWidth}) {
                    const Vec p = Vec{radius * std::cos(angle), y, radius * std::sin(angle)} - at;
                    for (double x : {p.x, p.y, p.z}) points.push_back(dReal(x));
                }
        const dGeomID stone = dCreateConvexHull(stage.space, points.data(), 8, 0);
        if (i == 0 || i == kStones - 1) {
            stage.place(stone, at);
            continue;
        }
        dMass mass;
        dMassSetBoxTotal(&mass, 300, 0.5, 2 * kHalfWidth, 0.5);
        stage.body(stone, mass, at);
    }
    stand(run, stage, 1, 3, "sag");
}

// Three balls in a frame and one on top, at sqrt(2/3) of a diameter above their centres.
void run_cannonballs(Run& run)
{
    constexpr double kRadius = 0.1, kMass = 33;
    const double ring = 2 * kRadius / std::sqrt(3.0), height = kRadius + 2 * kRadius * std::sqrt(2.0 / 3);
    Stage stage(run);
    stage.surface.friction = 0.3;
    stage.floor();
    for (int k = 0; k < 3; ++k) {
        const double angle = kPi / 2 + k * 2 * kPi / 3;
        const Vec out{std::cos(angle), std::sin(angle), 0};
        stage.ball(kRadius, kMass, ring * out + kRadius * kZ);
        stage.block({0.05, 1, 0.2}, (ring + kRadius + 0.025) * out + 0.1 * kZ, turn(kZ, angle));
    }
    const dBodyID top = stage.ball(kRadius, kMass, {0, 0, height});
    stage.advance(3.5);
    stage.advance(0.5, [&] {
        run.record("height", 1000 * std::max(std::fabs(position(top).z - height) - 4 * stage.layer(), 0.0));
    });
}

void run_slab(Run& run)
{
    Stage stage(run);
    stage.floor();
    for (int i = 0; i < 4; ++i) stage.box({0.3, 0.3, 1}, 20, {i < 2 ? 1.5 : -1.5, i % 2 ? 1.0 : -1.0, 0.5});
    const dBodyID slab = stage.box({4, 3, 0.4}, 20000, {0, 0, 1.2});
    stand(run, stage, 1, 3, "way");
    run.record("sink", 1000 * std::fabs(position(slab).z - 1.2));
}

// At 60 degrees it needs a coefficient of 1 / (2 tan 60) = 0.29, at 50 of 0.42.
void lean(Run& run, double angle, bool holds)
{
    constexpr double kLength = 4, kThick = 0.06;
    Stage stage(run);
    stage.surface.friction = 0.35;
    stage.floor();
    const dMaterial rough = stage.surface;
    stage.surface.friction = 0, stage.surface.friction_rule = dCombineMinimum;
    stage.block({0.2, 4, 8}, {-0.1, 0, 4});
    stage.surface = rough;
    const Turn q = turn(kY, angle - kPi / 2);
    const Vec up = rotate(q, kZ);
    const dBodyID ladder = stage.box({kThick, 0.5, kLength}, 12,
                                     {kThick / 2 * std::sin(angle) - up.x * kLength / 2, 0,
                                      up.z * kLength / 2 + kThick / 2 * std::cos(angle)},
                                     q);
    if (holds) return stand(run, stage, 0.5, 2.5, "holds");
    const Vec start = position(ladder);
    stage.advance(3);
    run.record("slides", length(position(ladder) - start) < 0.3);
}

void run_ladders(Run& run)
{
    lean(run, 60 * kPi / 180, true);
    lean(run, 50 * kPi / 180, false);
}

}  // namespace

extern const Scene kMeshCrates{
    "Rest",
    "mesh_crates",
    "three crates of triangles on each other, turned by 0, 1e-6 and 0.1 rad, 3 s",
    {{"way", "way from 1 s on", "mm", 1}, {"height", "height of the top one, off the law", "mm", 2}},
    &run_mesh_crates};

extern const Scene kArch{"Rest",
                         "arch",
                         "nine loose stones of 300 kg in an arch of 4 m, mu 0.7, 4 s",
                         {{"sag", "way of a stone from 1 s on", "mm", 2}},
                         &run_arch};

extern const Scene kCannonballs{"Rest",
                                "cannonballs",
                                "an iron ball of 0.1 m on three others in a frame, 4 s",
                                {{"height", "its height, off the law", "mm", 0.5}},
                                &run_cannonballs};

extern const Scene kSlab{
    "Rest",
    "slab",
    "a slab of 20 t on four loose legs of 20 kg, 4 s",
    {{"sink", "height of the slab, off the law", "mm", 2.1}, {"way", "way from 1 s on", "mm", 1}},
    &run_slab};

extern const Scene kLadders{
    "Rest",
    "ladders",
    "ladders at 60 and 50 degrees to a floor of mu 0.35 and a smooth wall",
    {{"holds", "way at 60 degrees from 0.5 s on", "mm", 2}, {"slides", "1 if the other stands", "1", 0}},
    &run_ladders};

}  // namespace epode::trials
