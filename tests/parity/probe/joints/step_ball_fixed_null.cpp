// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with the joints that have no limits: ball, fixed (with and without dJointSetFixed), null,
// and with a free body, disabled joints, kinematic partners and re-attachment.
#include "limit_states.h"

namespace parity {
namespace {

dJointID create_ball(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateBall(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = random.in_cube(1.0);
    dJointSetBallAnchor(joint, p.x, p.y, p.z);
    return joint;
}

void put_ball(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor", joint, &dJointGetBallAnchor);
    put_vector(out, when + ".anchor2", joint, &dJointGetBallAnchor2);
    out.put(when + ".params", {dJointGetBallParam(joint, dParamERP), dJointGetBallParam(joint, dParamCFM)});
}

dJointID create_fixed(const Rig& rig, Random&)
{
    const dJointID joint = dJointCreateFixed(rig.world(), nullptr);
    rig.attach(joint);
    dJointSetFixed(joint);
    return joint;
}

dJointID create_fixed_unset(const Rig& rig, Random&)
{
    const dJointID joint = dJointCreateFixed(rig.world(), nullptr);
    rig.attach(joint);
    return joint;
}

void put_fixed(Output& out, const std::string& when, dJointID joint)
{
    out.put(when + ".params", {dJointGetFixedParam(joint, dParamERP), dJointGetFixedParam(joint, dParamCFM)});
}

dJointID create_null(const Rig& rig, Random&)
{
    const dJointID joint = dJointCreateNull(rig.world(), nullptr);
    rig.attach(joint);
    return joint;
}

void put_nothing(Output& out, const std::string& when, dJointID joint)
{
    out.put(when + ".bodies", {static_cast<double>(dJointGetNumBodies(joint))});
}

std::vector<JointVariant> soft_variants(SetParam set)
{
    return {
        {"plain", [](dJointID, Random&) {}},
        {"disabled", [](dJointID joint, Random&) { dJointDisable(joint); }},
        {"erp", [=](dJointID joint, Random& random) { set(joint, dParamERP, random.range(0, 1)); }},
        {"cfm", [=](dJointID joint, Random& random) { set(joint, dParamCFM, random.range(1e-4, 1e-1)); }},
        {"kinematic",
         [](dJointID joint, Random&) {
             const dBodyID second = dJointGetBody(joint, 1);
             if (second != nullptr && dJointGetBody(joint, 0) != nullptr) { dBodySetKinematic(second); }
         }},
        {"reattached",
         [](dJointID joint, Random& random) {
             const dBodyID first = dJointGetBody(joint, 0), second = dJointGetBody(joint, 1);
             const dBodyID other = dBodyCreate(dBodyGetWorld(first != nullptr ? first : second));
             set_random_mass(other, random);
             set_random_pose(other, random, 1.0);
             dJointAttach(joint, second, other);
         }},
        {"no-gyroscope",
         [](dJointID joint, Random&) {
             const dBodyID first = dJointGetBody(joint, 0);
             dBodySetGyroscopicMode(first != nullptr ? first : dJointGetBody(joint, 1), 0);
         }},
    };
}

void set_no_param(dJointID, int, dReal) {}

PARITY_CASE(step_ball) { run_bench(out, rng, {create_ball, put_ball, soft_variants(&dJointSetBallParam)}); }

PARITY_CASE(step_fixed)
{
    run_bench(out, rng, {create_fixed, put_fixed, soft_variants(&dJointSetFixedParam)});
}

PARITY_CASE(step_fixed_unset)
{
    run_bench(out, rng, {create_fixed_unset, put_fixed, soft_variants(&dJointSetFixedParam)});
}

PARITY_CASE(step_null) { run_bench(out, rng, {create_null, put_nothing, soft_variants(&set_no_param)}); }

// Anchor 2 set apart from anchor 1: the setter stores its numbers raw.
PARITY_CASE(step_ball_anchor2)
{
    JointBench bench{create_ball, put_ball, {}};
    bench.variants.push_back({"anchor2", [](dJointID joint, Random& random) {
                                  const Vec3 p = random.in_cube(1.0);
                                  dJointSetBallAnchor2(joint, p.x, p.y, p.z);
                              }});
    run_bench(out, rng, bench);
}

}  // namespace
}  // namespace parity
