// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box3D's convex pile, a tower of loose hulls of 32 points that comes down, and its junkyard, a walled yard
// of rocks of 10 points with a cylinder that goes round in it. Size: hulls, of 8 by 8 or 21 by 21 a layer.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void build_pile(SceneData& scene, int count)
{
    constexpr int kAcross = 8;
    Lcg random(42);
    scene.gravity = 10;
    add_floor(scene, 250);
    const int hull = add_shape(scene, make_hull(random_points(32, 2, random)));
    for (int n = 0; n < count; ++n) {
        const int i = n % kAcross, j = n / kAcross % kAcross;
        add_body(scene, hull, {4.0 * (i - 4), 4.0 * (j - 4), 2 + 4.0 * (n / (kAcross * kAcross))});
    }
}

void add_yard(SceneData& scene)
{
    add_floor(scene, 120);
    const int along_x = add_shape(scene, box({100, 2, 16})), along_y = add_shape(scene, box({2, 100, 16}));
    for (double sign : {-1.0, 1.0}) {
        add_static(scene, along_x, {0, 50 * sign, 8});
        add_static(scene, along_y, {50 * sign, 0, 8});
    }
    BodyData pusher;
    pusher.motion = Motion::kDriven;
    pusher.parts = {{add_shape(scene, cylinder(4, 24)), {}, {}}};
    pusher.pos = {35, 0, 12.01};
    pusher.drive.orbit = -6 * scenes::kPi / 180;
    scene.bodies.push_back(pusher);
}

void build_yard(SceneData& scene, int count)
{
    constexpr int kAcross = 21;
    scene.gravity = 10;
    add_yard(scene);
    const int rock = add_shape(scene, make_hull(spiral_points(10, 1.5)));
    for (int n = 0; n < count; ++n) {
        const double x = -40 + 4.0 * (n % kAcross), y = -40 + 4.0 * (n / kAcross % kAcross);
        add_body(scene, rock, {x, y, 25 + 4.0 * (n / (kAcross * kAcross))});
    }
}

}  // namespace

extern const SceneRecipe kConvexPileScene = {
    "Box3D's tower of hulls", build_pile, {{"convex-pile", 5120, 500, 64, 60}}};
extern const SceneRecipe kJunkyardScene = {
    "Box3D's yard of rocks", build_yard, {{"junkyard", 10584, 500, 441, 160}}};

}  // namespace epode::bench
