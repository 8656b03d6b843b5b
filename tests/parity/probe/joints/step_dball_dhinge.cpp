// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with a double ball and with a double hinge: a rod between two points, and a bar between two
// parallel hinges.
#include "limit_states.h"

namespace parity {
namespace {

dJointID create_dball(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateDBall(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = random.in_cube(1.0), q = random.in_cube(1.0);
    dJointSetDBallAnchor1(joint, p.x, p.y, p.z);
    dJointSetDBallAnchor2(joint, q.x, q.y, q.z);
    return joint;
}

// Both ends in one place.
dJointID create_short_dball(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateDBall(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = random.in_cube(1.0);
    dJointSetDBallAnchor1(joint, p.x, p.y, p.z);
    dJointSetDBallAnchor2(joint, p.x, p.y, p.z);
    return joint;
}

void put_dball(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor1", joint, &dJointGetDBallAnchor1);
    put_vector(out, when + ".anchor2", joint, &dJointGetDBallAnchor2);
    out.put(when + ".distance", {dJointGetDBallDistance(joint)});
    out.put(when + ".params", {dJointGetDBallParam(joint, dParamERP), dJointGetDBallParam(joint, dParamCFM)});
}

dJointID create_dhinge(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateDHinge(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = random.in_cube(1.0), q = random.in_cube(1.0), n = random.direction();
    dJointSetDHingeAxis(joint, n.x, n.y, n.z);
    dJointSetDHingeAnchor1(joint, p.x, p.y, p.z);
    dJointSetDHingeAnchor2(joint, q.x, q.y, q.z);
    return joint;
}

void put_dhinge(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor1", joint, &dJointGetDHingeAnchor1);
    put_vector(out, when + ".anchor2", joint, &dJointGetDHingeAnchor2);
    put_vector(out, when + ".axis", joint, &dJointGetDHingeAxis);
    out.put(when + ".distance", {dJointGetDHingeDistance(joint)});
    out.put(when + ".params",
            {dJointGetDHingeParam(joint, dParamERP), dJointGetDHingeParam(joint, dParamCFM)});
}

std::vector<JointVariant> softness(SetParam set)
{
    return {{"plain", [](dJointID, Random&) {}}, {"soft", [set](dJointID joint, Random& random) {
                                                      set(joint, dParamERP, random.range(0.1, 0.9));
                                                      set(joint, dParamCFM, random.range(1e-4, 1e-1));
                                                  }}};
}

PARITY_CASE(step_dball)
{
    JointBench bench{create_dball, put_dball, softness(&dJointSetDBallParam)};
    bench.variants.push_back({"distance", [](dJointID joint, Random& random) {
                                  dJointSetDBallDistance(joint, random.range(0, 2));
                              }});
    bench.variants.push_back({"one-anchor", [](dJointID joint, Random& random) {
                                  const Vec3 p = random.in_cube(1.0);
                                  dJointSetDBallAnchor2(joint, p.x, p.y, p.z);
                              }});
    run_bench(out, rng, bench);
}

PARITY_CASE(step_dball_short)
{
    JointBench bench{create_short_dball, put_dball, softness(&dJointSetDBallParam)};
    bench.variants.push_back({"distance", [](dJointID joint, Random& random) {
                                  dJointSetDBallDistance(joint, random.range(0, 0.1));
                              }});
    bench.distance = bench.angle = 0;
    run_bench(out, rng, bench);
}

PARITY_CASE(step_dhinge)
{
    JointBench bench{create_dhinge, put_dhinge, softness(&dJointSetDHingeParam)};
    bench.variants.push_back({"one-anchor", [](dJointID joint, Random& random) {
                                  const Vec3 p = random.in_cube(1.0);
                                  dJointSetDHingeAnchor1(joint, p.x, p.y, p.z);
                              }});
    bench.variants.push_back({"axis", [](dJointID joint, Random& random) {
                                  const Vec3 n = random.direction();
                                  dJointSetDHingeAxis(joint, n.x, n.y, n.z);
                              }});
    run_bench(out, rng, bench);
}

}  // namespace
}  // namespace parity
