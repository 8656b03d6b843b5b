// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box3D's washer: small cubes in a drum of 36 slabs with four paddles that turns about a level axis, open at
// its ends. Size: cubes along an edge of their block.
#include <cmath>

#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

constexpr double kInner = 16, kOuter = 18, kLength = 20;  // m, along y

BodyData make_drum(SceneData& scene)
{
    constexpr int kSlabs = 36, kPaddles = 4;
    const double chord = 2 * kOuter * std::tan(scenes::kPi / kSlabs);
    const int slab = add_shape(scene, box({kOuter - kInner, kLength, chord}));
    const int paddle = add_shape(scene, box({2, kLength, 0.5}));
    BodyData drum;
    drum.motion = Motion::kDriven;
    const auto add = [&](int shape, double radius, double angle) {
        const Turn q = scenes::turn(scenes::kY, angle);
        drum.parts.push_back({shape, rotate(q, {radius, 0, 0}), q});
    };
    for (int i = 0; i < kSlabs; ++i) add(slab, (kInner + kOuter) / 2, 2 * scenes::kPi * i / kSlabs);
    for (int i = 0; i < kPaddles; ++i) add(paddle, kInner - 1, 2 * scenes::kPi * (i + 0.5) / kPaddles);
    drum.pos = {0, 0, 21};
    drum.drive.spin = {0, 25 * scenes::kPi / 180, 0};
    return drum;
}

void build(SceneData& scene, int across)
{
    constexpr double kPitch = 0.8;
    scene.gravity = 10;
    add_floor(scene, 60);
    scene.bodies.push_back(make_drum(scene));
    const int cube = add_shape(scene, box({0.4, 0.4, 0.4}));
    const double low = -0.5 * kPitch * across;
    for (int n = 0; n < across * across * across; ++n) {
        const double x = low + kPitch * (n % across), y = low + kPitch * (n / across % across);
        add_body(scene, cube, {x, y, 21 + low + kPitch * (n / (across * across))});
    }
}

}  // namespace

extern const SceneRecipe kWasherScene = {"Box3D's washing drum", build, {{"washer", 20, 300, 7, 150}}};

}  // namespace epode::bench
