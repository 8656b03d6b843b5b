// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See human.h. Joints sit in the middle between the ends of neighbouring capsules.
#include "bench/scenes/human.h"

namespace epode::bench {

namespace {

// One ragdoll while it is made: parts are placed in its own frame.
class Maker {
  public:
    Maker(SceneData& scene, const HumanPose& pose) : scene_(scene), pose_(pose) {}

    int part(int shape, Vec at, Turn q = {})
    {
        const int body = add_body(scene_, shape, place(at), pose_.turn * q);
        scene_.bodies[size_t(body)].group = pose_.group;
        return body;
    }
    void ball(int body1, int body2, Vec at) { add_ball(scene_, body1, body2, place(at)); }
    void hinge(int body1, int body2, Vec at, double low, double high)
    {
        add_hinge(scene_, body1, body2, place(at), rotate(pose_.turn, scenes::kY), low, high);
    }

  private:
    Vec place(Vec at) const { return pose_.pos + rotate(pose_.turn, at); }

    SceneData& scene_;
    const HumanPose& pose_;
};

}  // namespace

HumanShapes add_human_shapes(SceneData& scene)
{
    return {add_shape(scene, capsule(0.14, 0.16)), add_shape(scene, sphere(0.11)),
            add_shape(scene, capsule(0.045, 0.2)), add_shape(scene, capsule(0.065, 0.28)),
            add_shape(scene, sphere(0.06))};
}

void add_human(SceneData& scene, const HumanShapes& shapes, const HumanPose& pose)
{
    constexpr double kBend = 2;  // rad
    const Turn across = scenes::turn(scenes::kX, scenes::kPi / 2);
    Maker make(scene, pose);
    const int pelvis = make.part(shapes.trunk, {0, 0, 0}, across);
    const int chest = make.part(shapes.trunk, {0, 0, 0.34});
    const int head = make.part(shapes.head, {0, 0, 0.72});
    make.ball(pelvis, chest, {0, 0, 0.14});
    make.ball(chest, head, {0, 0, 0.6});
    for (double side : {-1.0, 1.0}) {
        const int upper = make.part(shapes.arm, {0, side * 0.29, 0.33});
        const int fore = make.part(shapes.arm, {0, side * 0.29, 0.03});
        make.ball(chest, upper, {0, side * 0.25, 0.48});
        make.hinge(upper, fore, {0, side * 0.29, 0.18}, -kBend, 0.05);
        const int thigh = make.part(shapes.leg, {0, side * 0.1, -0.35});
        const int shin = make.part(shapes.leg, {0, side * 0.1, -0.77});
        make.ball(pelvis, thigh, {0, side * 0.1, -0.14});
        make.hinge(thigh, shin, {0, side * 0.1, -0.56}, -0.05, kBend);
        if (!pose.hands_and_feet) continue;
        make.ball(fore, make.part(shapes.end, {0, side * 0.29, -0.17}), {0, side * 0.29, -0.115});
        make.ball(shin, make.part(shapes.end, {0, side * 0.1, -1.03}), {0, side * 0.1, -0.97});
    }
}

}  // namespace epode::bench
