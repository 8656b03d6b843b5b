// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with an angular motor: user mode with one to three axes of every frame (world, first body,
// second body) and given angles, and Euler mode, where the library computes the angles itself.
#include "limit_states.h"

namespace parity {
namespace {

template <int kAxes>
dJointID create_user(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateAMotor(rig.world(), nullptr);
    rig.attach(joint);
    dJointSetAMotorMode(joint, dAMotorUser);
    dJointSetAMotorNumAxes(joint, kAxes);
    for (int i = 0; i < kAxes; ++i) {
        const Vec3 n = random.direction();
        dJointSetAMotorAxis(joint, i, random.below(3), n.x, n.y, n.z);
        dJointSetAMotorAngle(joint, i, random.range(-0.6, 0.6));
    }
    return joint;
}

dJointID create_euler(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateAMotor(rig.world(), nullptr);
    rig.attach(joint);
    const Quat q = random.rotation(3.0);
    const Vec3 first = rotate(q, {1, 0, 0}), last = rotate(q, {0, 0, 1});
    dJointSetAMotorMode(joint, dAMotorEuler);
    dJointSetAMotorAxis(joint, 0, 1, first.x, first.y, first.z);
    dJointSetAMotorAxis(joint, 2, 2, last.x, last.y, last.z);
    return joint;
}

// Axes given with rel 0, as seen from the bodies that they belong to: both, the first or the last.
template <int kRel0, int kRel2>
dJointID create_euler_with_rel(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateAMotor(rig.world(), nullptr);
    rig.attach(joint);
    dJointSetAMotorMode(joint, dAMotorEuler);
    if (random.below(2)) { dJointSetAMotorAxis(joint, 1, 0, 0.3, 1, 0.2); }
    dJointSetAMotorAxis(joint, 0, kRel0, 1, 0, 0);
    dJointSetAMotorAxis(joint, 2, kRel2, 0, 0, 1);
    return joint;
}

void put_amotor(Output& out, const std::string& when, dJointID joint)
{
    const int axes = dJointGetAMotorNumAxes(joint);
    out.put(when + ".mode", {static_cast<double>(dJointGetAMotorMode(joint)), static_cast<double>(axes)});
    for (int i = 0; i < axes; ++i) {
        const std::string index = std::to_string(i);
        dVector3 axis = {0, 0, 0, 0};
        dJointGetAMotorAxis(joint, i, axis);
        out.put(when + ".axis" + index, axis, 3);
        out.put(when + ".rel" + index, {static_cast<double>(dJointGetAMotorAxisRel(joint, i))});
        out.put(when + ".angle" + index, {dJointGetAMotorAngle(joint, i)});
        out.put(when + ".rate" + index, {dJointGetAMotorAngleRate(joint, i)});
        put_params(out, when + ".params" + index, joint, &dJointGetAMotorParam, i * dParamGroup);
    }
}

void add_torques(dJointID joint, Random& random)
{
    const Vec3 t = random.in_cube(5);
    dJointAddAMotorTorques(joint, t.x, t.y, t.z);
}

void all_motors(dJointID joint, Random& random)
{
    for (int i = 0; i < dJointGetAMotorNumAxes(joint); ++i) {
        dJointSetAMotorParam(joint, dParamVel + i * dParamGroup, random.range(-3, 3));
        dJointSetAMotorParam(joint, dParamFMax + i * dParamGroup, random.range(0.1, 200));
    }
}

std::vector<JointVariant> variants_of(int axes)
{
    std::vector<JointVariant> variants;
    for (int i = 0; i < axes; ++i) {
        const std::string prefix = "axis" + std::to_string(i) + "-";
        add_variants(variants, limit_variants(&dJointSetAMotorParam, i * dParamGroup, prefix));
    }
    variants.push_back({"add-torques", add_torques});
    variants.push_back({"all-motors", all_motors});
    return variants;
}

PARITY_CASE(step_amotor_user1) { run_bench(out, rng, {create_user<1>, put_amotor, variants_of(1)}); }

PARITY_CASE(step_amotor_user2)
{
    JointBench bench{create_user<2>, put_amotor, variants_of(2)};
    bench.poses = 10;
    run_bench(out, rng, bench);
}

PARITY_CASE(step_amotor_user3)
{
    JointBench bench{create_user<3>, put_amotor, variants_of(3)};
    bench.poses = 7;
    run_bench(out, rng, bench);
}

PARITY_CASE(step_amotor_euler) { run_bench(out, rng, {create_euler, put_amotor, variants_of(3)}); }

// The stops of one that is attached as (0, B) are left out (differences.tsv, D33).
PARITY_CASE(step_amotor_euler_world)
{
    const auto run = [&](auto create, const char* name) {
        JointBench bench{create, put_amotor, variants_of(3)};
        bench.poses = 5;
        for (JointVariant& variant : bench.variants) { variant.name = name + variant.name; }
        bench.attachments = {Attach::kAB, Attach::kBA, Attach::kA0};
        run_bench(out, rng, bench);
        std::erase_if(bench.variants, [](const JointVariant& variant) {
            return !variant.name.ends_with("add-torques") && !variant.name.ends_with("all-motors");
        });
        bench.attachments = {Attach::kOA};
        run_bench(out, rng, bench);
    };
    run(create_euler_with_rel<0, 0>, "rel00-");
    run(create_euler_with_rel<1, 0>, "rel10-");
    run(create_euler_with_rel<0, 2>, "rel02-");
}

}  // namespace
}  // namespace parity
