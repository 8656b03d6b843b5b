// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with a hinge and with a slider: every state of their single limit and motor, every way of
// attaching, and the helpers that apply torque or force or shift the zero.
#include "limit_states.h"

namespace parity {
namespace {

dJointID create_hinge(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateHinge(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = random.in_cube(1.0), n = random.direction();
    dJointSetHingeAnchor(joint, p.x, p.y, p.z);
    dJointSetHingeAxis(joint, n.x, n.y, n.z);
    return joint;
}

void put_hinge(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor", joint, &dJointGetHingeAnchor);
    put_vector(out, when + ".anchor2", joint, &dJointGetHingeAnchor2);
    put_vector(out, when + ".axis", joint, &dJointGetHingeAxis);
    out.put(when + ".angle", {dJointGetHingeAngle(joint)});
    out.put(when + ".rate", {dJointGetHingeAngleRate(joint)});
    put_params(out, when + ".params", joint, &dJointGetHingeParam, 0);
}

dJointID create_slider(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateSlider(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 n = random.direction();
    dJointSetSliderAxis(joint, n.x, n.y, n.z);
    return joint;
}

void put_slider(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".axis", joint, &dJointGetSliderAxis);
    out.put(when + ".position", {dJointGetSliderPosition(joint)});
    out.put(when + ".rate", {dJointGetSliderPositionRate(joint)});
    put_params(out, when + ".params", joint, &dJointGetSliderParam, 0);
}

PARITY_CASE(step_hinge)
{
    JointBench bench{create_hinge, put_hinge, limit_variants(&dJointSetHingeParam, 0, "")};
    bench.variants.push_back({"add-torque", [](dJointID joint, Random& random) {
                                  dJointAddHingeTorque(joint, random.range(-5, 5));
                              }});
    bench.variants.push_back({"axis-offset", [](dJointID joint, Random& random) {
                                  const Vec3 n = random.direction();
                                  dJointSetHingeAxisOffset(joint, n.x, n.y, n.z, random.range(-1, 1));
                              }});
    bench.variants.push_back({"anchor-delta", [](dJointID joint, Random& random) {
                                  const Vec3 p = random.in_cube(1), d = random.in_cube(0.2);
                                  dJointSetHingeAnchorDelta(joint, p.x, p.y, p.z, d.x, d.y, d.z);
                              }});
    run_bench(out, rng, bench);
}

PARITY_CASE(step_slider)
{
    JointBench bench{create_slider, put_slider, limit_variants(&dJointSetSliderParam, 0, "")};
    bench.distance = 0.35;
    bench.variants.push_back({"add-force", [](dJointID joint, Random& random) {
                                  dJointAddSliderForce(joint, random.range(-5, 5));
                              }});
    bench.variants.push_back({"axis-delta", [](dJointID joint, Random& random) {
                                  const Vec3 n = random.direction(), d = random.in_cube(0.2);
                                  dJointSetSliderAxisDelta(joint, n.x, n.y, n.z, d.x, d.y, d.z);
                              }});
    run_bench(out, rng, bench);
}

}  // namespace
}  // namespace parity
