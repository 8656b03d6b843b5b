// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See chain.h. The world's end of the first joint is a static body without a shape.
#include "bench/scenes/chain.h"

namespace epode::bench {

void add_chain(SceneData& scene, int joints, double last_mass)
{
    const Turn level = scenes::turn(scenes::kY, scenes::kPi / 2);
    const int link = add_shape(scene, capsule(0.1, 0.8));
    BodyData world;
    world.motion = Motion::kFixed;
    world.collides = false;
    scene.bodies.push_back(world);
    for (int i = 0; i < joints; ++i) {
        const int body = add_body(scene, link, {i + 0.5, 0, 0}, level);
        BodyData& made = scene.bodies[size_t(body)];
        made.collides = false;
        set_mass(made, i + 1 < joints ? 1 : last_mass);
        add_ball(scene, body - 1, body, {double(i), 0, 0});
    }
    scene.lost_below = -1e6;
    scene.exact = true;
}

}  // namespace epode::bench
