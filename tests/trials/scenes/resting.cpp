// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is put down at rest on a level floor stays where it is.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr Turn kLying{0.7071067811865476, 0.7071067811865476, 0, 0};  // along y

// The speed in the last part of the run, and how far each body has moved along the floor.
void watch(Run& run, Stage& stage, double seconds, const char* speed, const char* moved)
{
    const std::vector<dBodyID> bodies = bodies_of(stage.world);
    std::vector<Vec> start;
    for (dBodyID body : bodies) start.push_back(position(body));
    stage.advance(0.9 * seconds);
    stage.advance(0.1 * seconds, [&] {
        for (dBodyID body : bodies) run.record(speed, across(velocity(body)));
    });
    for (size_t i = 0; i < bodies.size(); ++i)
        run.record(moved, 1000 * across(position(bodies[i]) - start[i]));
}

void park_car(Stage& stage, Vec at)
{
    stage.surface.friction = 1;
    const dBodyID chassis = stage.box({4.2, 1.6, 0.5}, 1200, at + 0.65 * kZ);
    for (int i = 0; i < 4; ++i) {
        const Vec place = at + Vec{i < 2 ? 1.35 : -1.35, i % 2 ? 0.9 : -0.9, 0.33};
        const dBodyID wheel = stage.ball(0.33, 20, place);
        const dJointID joint = dJointCreateHinge2(stage.world, nullptr);
        dJointAttach(joint, chassis, wheel);
        dJointSetHinge2Anchor(joint, place.x, place.y, place.z);
        const dReal up[3] = {0, 0, 1}, axle[3] = {0, 1, 0};
        dJointSetHinge2Axes(joint, up, axle);
        dJointSetSpring(joint, 45000, 4000);
        for (int stop : {dParamLoStop, dParamHiStop}) dJointSetHinge2Param(joint, stop, 0);
    }
}

void stay(Run& run)
{
    for (double radius : {0.0025, 0.01, 0.05, 0.2}) {
        Stage stage(run);
        if (radius < 0.05) stage.toys();
        stage.floor();
        const double mass = 7800 * 4 / 3.0 * kPi * radius * radius * radius;
        stage.ball(radius, mass, {14 * radius, 8.4 * radius, radius});
        stage.cylinder(radius, 4 * radius, 3 * mass, {-14 * radius, 8.4 * radius, radius}, kLying);
        stage.capsule(radius, 4 * radius, 4 * mass, {14 * radius, -8.4 * radius, radius}, kLying);
        watch(run, stage, 10, "speed", "moved");
    }
    Stage stage(run);
    stage.floor();
    park_car(stage, {3, 2, 0});
    stage.advance(2);  // the springs give way
    watch(run, stage, 8, "car", "car_moved");
}

// A battery on a table of a box, and of two triangles.
void lie(Run& run)
{
    constexpr double kRadius = 0.007, kLength = 0.05, kGap = 0.002;
    const Turn flat = turn(kZ, 30 * kPi / 180) * turn(kY, kPi / 2);
    for (int trial = 0; trial < 6; ++trial) {
        const int shape = trial % 3;
        Stage stage(run);
        stage.toys();
        stage.surface.friction = 0.8;
        if (trial < 3)
            stage.block({1, 1, 0.05}, {0, 0, -0.025});
        else  // the diagonal runs below the body
            mesh(stage, {{-0.5, -0.25, 0}, {0.5, -0.5, 0}, {0.5, 0.25, 0}, {-0.5, 0.5, 0}},
                 {0, 1, 2, 0, 2, 3});
        const Vec at{0.1, 0.05, kRadius + kGap};
        const dBodyID body = shape == 0   ? stage.cylinder(kRadius, kLength, 0.023, at, flat)
                             : shape == 1 ? stage.capsule(kRadius, kLength - 2 * kRadius, 0.023, at, flat)
                                          : stage.box({2 * kRadius, 2 * kRadius, kLength}, 0.023, at, flat);
        stage.advance(2);
        std::vector<double> heights;
        double mean = 0;
        stage.advance(2, [&] {
            const Vec axis = rotate(orientation(body), kZ);
            heights.push_back(position(body).z);
            mean += heights.back();
            run.record("depth", 1000 * (kRadius - heights.back()));
            run.record("tilt", degrees(std::asin(std::fabs(axis.z))));
            run.record("pitch", length(cross(spin(body), axis)));
        });
        mean /= double(heights.size());
        double square = 0;
        for (double z : heights) square += (z - mean) * (z - mean) / double(heights.size());
        run.record("tremble", 1e6 * std::sqrt(square));
        run.record("rolled", 1000 * across(position(body) - at));
    }
}

// Steel balls, capsules and ellipsoids of a few millimetres on a block that is turned in plan.
void lie_tiny(Run& run)
{
    constexpr double kRadius = 0.0025;
    Stage stage(run);
    stage.toys();
    stage.surface.friction = 1;
    stage.block({0.2, 0.2, 0.05}, {0, 0, -0.025}, turn(kZ, 20 * kPi / 180));
    std::vector<std::pair<dBodyID, Vec>> bodies;
    std::vector<double> heights;
    Lcg random(7);
    for (int i = 0; i < 12; ++i) {
        const Vec at{0.013 * (i % 4) - 0.031 + random.uniform(0, 1e-3),
                     0.017 * (i / 4) - 0.023 + random.uniform(0, 1e-3), kRadius};
        const Turn flat = turn(kZ, random.uniform(0, 3)) * turn(kY, kPi / 2);
        dMass mass;
        dMassSetEllipsoid(&mass, 7800, 0.004, 0.003, kRadius);
        const dBodyID body = i % 3 == 0 ? stage.ball(kRadius, 5.1e-4, at)
                             : i % 3 == 1
                                 ? stage.capsule(kRadius, 0.01, 2e-3, at, flat)
                                 : stage.body(dCreateEllipsoid(stage.space, 0.004, 0.003, kRadius), mass, at);
        bodies.emplace_back(body, at);
    }
    stage.advance(19);
    stage.advance(1, [&] {
        for (const auto& [body, at] : bodies) run.record("spin", length(spin(body)));
    });
    for (const auto& [body, at] : bodies) {
        run.record("moved", 1000 * across(position(body) - at));
        run.record("depth", 1000 * (at.z - position(body).z));
    }
}

// Eight cubes on each other. Ten seconds for a metre are as long as one second for a centimetre.
void build_towers(Run& run)
{
    const struct {
        double edge;
        const char* law;
    } towers[] = {{0.01, "1_cm"}, {0.05, "5_cm"}, {1, "1_m"}};
    for (const auto& tower : towers) {
        Stage stage(run);
        if (tower.edge < 0.1) stage.toys();
        stage.floor();
        std::vector<dBodyID> cubes;
        const double edge = tower.edge;
        for (int i = 0; i < 8; ++i)
            cubes.push_back(
                stage.box({edge, edge, edge}, 1000 * edge * edge * edge, {0, 0, (i + 0.5) * edge}));
        stage.advance(10);
        for (int i = 0; i < 8; ++i) {
            const Vec off = position(cubes[size_t(i)]) - Vec{0, 0, (i + 0.5) * edge};
            const double sunk = std::max(std::fabs(off.z) - (i + 1) * stage.layer(), 0.0);
            run.record(tower.law, 100 * std::max(across(off), sunk) / edge);
        }
    }
}

}  // namespace

extern const Scene kRoundAtRest{
    "Rest",
    "round_at_rest",
    "balls, lying cylinders and capsules of 2.5 mm to 0.2 m, and a car with free wheels, put down at rest",
    {{"speed", "speed along the floor after 9 s", "m/s", 1e-6},
     {"moved", "way in 10 s", "mm", 0.01},
     {"car", "speed of the car after 9 s", "m/s", 1e-6},
     {"car_moved", "its way in 8 s", "mm", 0.01}},
    &stay};

extern const Scene kBattery{
    "Rest",
    "battery",
    "a battery of 23 g, as cylinder, capsule and box, falls 2 mm on its side (C9); from 2 s on",
    {{"depth", "depth", "mm", 0.1},
     {"tilt", "tilt of the axis", "degrees", 0.1},
     {"pitch", "rate of pitch and yaw", "rad/s", 0.01},
     {"tremble", "standard deviation of the height", "um", 5},
     {"rolled", "way", "mm", 1}},
    &lie};

extern const Scene kTinyAtRest{
    "Rest",
    "tiny_at_rest",
    "steel balls, capsules and ellipsoids of 2.5 mm at twelve places of a block, 20 s (C10)",
    {{"moved", "way", "mm", 0.01},
     {"spin", "angular velocity in the last second", "rad/s", 1e-3},
     {"depth", "depth", "mm", 0.02}},
    &lie_tiny};

extern const Scene kTowers{"Rest",
                           "towers",
                           "eight cubes on each other, 10 s",
                           {{"1_cm", "way off their places, cubes of 1 cm, of an edge", "%", 5},
                            {"5_cm", "the same, 5 cm", "%", 5},
                            {"1_m", "the same, 1 m", "%", 2}},
                           &build_towers};

}  // namespace epode::trials
