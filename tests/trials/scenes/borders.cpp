// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two height fields that share a border act as one. What slides on them without friction and without turning keeps its energy, and
// goes the way that it goes on one field of the same samples.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

enum class Slider { kCapsule, kBall, kBox };

double flat(double, double) { return 0; }
double bowl(double x, double) { return 0.02 * x * x; }
double waves(double x, double y) { return 0.1 * std::sin(x) * std::cos(y); }

void build_fields(Stage& stage, Height height, bool split)
{
    if (!split) {
        height_field(stage, {-10, -5, 20, 10, 1}, height);
        return;
    }
    height_field(stage, {-10, -5, 10, 10, 1}, height);
    height_field(stage, {0, -5, 10, 10, 1}, height);
}

// An inertia so large that it does not turn.
dBodyID add(Stage& stage, Slider kind, double floor)
{
    const double up = kind == Slider::kBall ? 0.3 : 0.8;
    dMass mass;
    dMassSetParameters(&mass, 70, 0, 0, 0, 7e7, 7e7, 7e7, 0, 0, 0);
    const dGeomID geom = kind == Slider::kBall      ? dCreateSphere(stage.space, 0.3)
                         : kind == Slider::kCapsule ? dCreateCapsule(stage.space, 0.3, 1)
                                                    : dCreateBox(stage.space, 0.6, 0.6, 1.6);
    const dBodyID body = stage.body(geom, mass, {-4, 0.37, floor + up + 0.001});
    set_velocity(body, {3, 0.4, 0});
    return body;
}

void slide_level(Run& run, Slider kind)
{
    Stage stage(run);
    stage.surface.friction = 0;
    build_fields(stage, flat, true);
    const dBodyID body = add(stage, kind, 0);
    stage.advance(0.1);
    stage.advance(2.9, [&] {
        const Vec v = velocity(body);
        run.record("speed", 100 * std::max(std::fabs(v.x / 3 - 1), std::fabs(v.y / 0.4 - 1)));
        run.record("hop", std::fabs(v.z));
    });
}

void slide_bowl(Run& run, Slider kind)
{
    Stage stage(run);
    stage.surface.friction = 0;
    build_fields(stage, bowl, true);
    const dBodyID body = add(stage, kind, bowl(-4, 0));
    const auto own = [&] { return dot(velocity(body), velocity(body)) / 2 + kGravity * position(body).z; };
    stage.advance(0.2);
    const double start = own();
    stage.advance(2.3, [&] { run.record("energy", 100 * std::fabs(own() - start) / 4.6); });
}

void slide_waves(Run& run, Slider kind)
{
    Stage one(run), two(run);
    dBodyID body[2];
    for (Stage* stage : {&one, &two}) {
        stage->surface.friction = 0;
        build_fields(*stage, waves, stage == &two);
        body[stage == &two] = add(*stage, kind, 0.07);
    }
    two.advance(2.5, [&] {
        one.step();
        run.record("path", 1000 * length(position(body[0]) - position(body[1])));
    });
}

void slide_all(Run& run)
{
    for (Slider kind : {Slider::kCapsule, Slider::kBall, Slider::kBox}) {
        slide_level(run, kind);
        if (kind != Slider::kBox) slide_bowl(run, kind);
        slide_waves(run, kind);
    }
}

}  // namespace

extern const Scene kFieldBorder{
    "Surfaces",
    "field_border",
    "capsules, balls and boxes that do not turn slide at 3 m/s over the border of two height fields (C17)",
    {{"speed", "change of velocity on level fields", "%", 0.1},
     {"hop", "vertical speed there", "m/s", 0.01},
     {"energy", "change of energy in a bowl, of the kinetic energy", "%", 5},
     {"path", "way off that on one field, over waves", "mm", 1}},
    &slide_all};

}  // namespace epode::trials
