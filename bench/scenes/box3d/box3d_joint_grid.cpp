// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box3D's joint grid: a hanging net of spheres on ball joints, half-way between neighbours; nothing collides.
// The top row is fixed. Size: spheres along an edge.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void build(SceneData& scene, int across)
{
    const int ball = add_shape(scene, sphere(0.4));
    scene.gravity = 10;
    scene.lost_below = -1e6;
    for (int k = 0; k < across; ++k) {
        for (int i = 0; i < across; ++i) {
            const Vec at{double(k), 0, -double(i)};
            const int body = i == 0 ? add_static(scene, ball, at) : add_body(scene, ball, at);
            scene.bodies[size_t(body)].collides = false;
            if (i > 0) add_ball(scene, body - 1, body, at + Vec{0, 0, 0.5});
            if (k > 0) add_ball(scene, body - across, body, at - Vec{0.5, 0, 0});
        }
    }
}

}  // namespace

extern const SceneRecipe kJointGridScene = {
    "Box3D's net of joints", build, {{"joint-grid", 100, 100, 20, 30}}};

}  // namespace epode::bench
