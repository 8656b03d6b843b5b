// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with a linear motor (one to three axes in every frame) and with the plane-2D joint (out of
// its plane, moving, turning, its three motors). Their stops are numbers that no step obeys, which the limit
// states show as well.
#include "limit_states.h"

namespace parity {
namespace {

template <int kAxes>
dJointID create_lmotor(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateLMotor(rig.world(), nullptr);
    rig.attach(joint);
    dJointSetLMotorNumAxes(joint, kAxes);
    for (int i = 0; i < kAxes; ++i) {
        const Vec3 n = random.direction();
        dJointSetLMotorAxis(joint, i, random.below(3), 2 * n.x, 2 * n.y, 2 * n.z);
    }
    return joint;
}

void put_lmotor(Output& out, const std::string& when, dJointID joint)
{
    const int axes = dJointGetLMotorNumAxes(joint);
    out.put(when + ".mode", {static_cast<double>(axes)});
    for (int i = 0; i < axes; ++i) {
        dVector3 axis = {0, 0, 0, 0};
        dJointGetLMotorAxis(joint, i, axis);
        out.put(when + ".axis" + std::to_string(i), axis, 3);
        put_params(out, when + ".params" + std::to_string(i), joint, &dJointGetLMotorParam, i * dParamGroup);
    }
}

JointVariant all_motors(int axes, SetParam set)
{
    return {"all-motors", [=](dJointID joint, Random& random) {
                for (int i = 0; i < axes; ++i) {
                    set(joint, dParamVel + i * dParamGroup, random.range(-3, 3));
                    set(joint, dParamFMax + i * dParamGroup, random.range(0.1, 200));
                }
            }};
}

std::vector<JointVariant> motor_variants(int axes)
{
    std::vector<JointVariant> variants;
    for (int i = 0; i < axes; ++i) {
        const std::string prefix = "axis" + std::to_string(i) + "-";
        add_variants(variants, limit_variants(&dJointSetLMotorParam, i * dParamGroup, prefix));
    }
    variants.push_back(all_motors(axes, &dJointSetLMotorParam));
    return variants;
}

PARITY_CASE(step_lmotor1) { run_bench(out, rng, {create_lmotor<1>, put_lmotor, motor_variants(1)}); }

PARITY_CASE(step_lmotor3)
{
    JointBench bench{create_lmotor<3>, put_lmotor, motor_variants(3)};
    bench.poses = 5;
    run_bench(out, rng, bench);
}

dJointID create_plane2d(const Rig& rig, Random&)
{
    const dJointID joint = dJointCreatePlane2D(rig.world(), nullptr);
    rig.attach(joint);
    return joint;
}

void put_plane2d(Output& out, const std::string& when, dJointID joint)
{
    out.put(when + ".type", {static_cast<double>(dJointGetType(joint))});
}

PARITY_CASE(step_plane2d)
{
    JointBench bench{create_plane2d, put_plane2d, limit_variants(&dJointSetPlane2DXParam, 0, "x-")};
    bench.attachments = {Attach::kA0};
    add_variants(bench.variants, limit_variants(&dJointSetPlane2DYParam, 0, "y-"));
    add_variants(bench.variants, limit_variants(&dJointSetPlane2DAngleParam, 0, "angle-"));
    bench.variants.push_back({"all-motors", [](dJointID joint, Random& random) {
                                  for (const SetParam set : {&dJointSetPlane2DXParam, &dJointSetPlane2DYParam,
                                                             &dJointSetPlane2DAngleParam}) {
                                      set(joint, dParamVel, random.range(-3, 3));
                                      set(joint, dParamFMax, random.range(0.1, 200));
                                      set(joint, dParamCFM, random.range(1e-4, 1e-2));
                                  }
                              }});
    run_bench(out, rng, bench);
}

// Numbers of other groups and unknown ones change nothing a step can show.
PARITY_CASE(step_plane2d_numbers)
{
    JointBench bench{create_plane2d, put_plane2d, {}};
    bench.attachments = {Attach::kA0};
    bench.poses = 5;
    for (int number = 0; number < 3 * dParamGroup; ++number) {
        if (number % dParamGroup >= 18) { continue; }
        bench.variants.push_back(
            {"number" + std::to_string(number), [number](dJointID joint, Random&) {
                 for (const SetParam set :
                      {&dJointSetPlane2DXParam, &dJointSetPlane2DYParam, &dJointSetPlane2DAngleParam}) {
                     set(joint, dParamFMax, 20);
                     set(joint, number, 0.3);
                 }
             }});
    }
    run_bench(out, rng, bench);
}

}  // namespace
}  // namespace parity
