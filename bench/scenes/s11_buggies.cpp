// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S11: buggies that drive: a chassis, four sprung wheels on hinge-2 joints, the rear ones driven. The wheels
// are spheres, so that every engine gives them one contact. Size: buggies.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

struct Shapes {
    int chassis, wheel;
};

void add_buggy(SceneData& scene, const Shapes& shapes, Vec pos)
{
    const int chassis = add_body(scene, shapes.chassis, pos, {}, 200);
    for (double front : {-1.0, 1.0}) {
        for (double side : {-1.0, 1.0}) {
            const Vec at = pos + Vec{1.1 * front, 0.8 * side, -0.2};
            const int wheel = add_body(scene, shapes.wheel, at, {}, 100);
            add_ball(scene, chassis, wheel, at);
            JointData& joint = scene.joints.back();
            joint.kind = JointKind::kHinge2;
            joint.axis1 = scenes::kZ;
            joint.axis2 = scenes::kY;
            joint.stiffness = 20000;
            joint.damping = 1500;
            joint.speed = 10;
            joint.torque = front < 0 ? 100 : 0;
        }
    }
}

void build(SceneData& scene, int count)
{
    int across = 1;
    while (across * across < count) ++across;
    add_floor(scene, 5.0 * across + 200);
    const Shapes shapes = {add_shape(scene, box({2.4, 1, 0.5})), add_shape(scene, sphere(0.35))};
    for (int n = 0; n < count; ++n)
        add_buggy(scene, shapes, {5 * (n % across - 0.5 * across), 4 * (n / across - 0.5 * across), 0.6});
}

}  // namespace

extern const SceneRecipe kBuggyScene = {"buggies on hinge-2 joints", build, {{"S11", 200, 300, 40, 60, 3}}};

}  // namespace epode::bench
