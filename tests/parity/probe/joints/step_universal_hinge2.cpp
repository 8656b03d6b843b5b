// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with a universal joint and with a hinge-2: two limited axes each; the suspension and the
// axis-to-axis angle of the latter.
#include "limit_states.h"

#include <cmath>

namespace parity {
namespace {

dJointID create_universal(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateUniversal(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = random.in_cube(1.0), n = random.direction(), m = perpendicular_to(n, random);
    dJointSetUniversalAnchor(joint, p.x, p.y, p.z);
    dJointSetUniversalAxis1(joint, n.x, n.y, n.z);
    dJointSetUniversalAxis2(joint, m.x, m.y, m.z);
    return joint;
}

void put_universal(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor", joint, &dJointGetUniversalAnchor);
    put_vector(out, when + ".anchor2", joint, &dJointGetUniversalAnchor2);
    put_vector(out, when + ".axis1", joint, &dJointGetUniversalAxis1);
    put_vector(out, when + ".axis2", joint, &dJointGetUniversalAxis2);
    dReal a1 = 0, a2 = 0;
    dJointGetUniversalAngles(joint, &a1, &a2);
    out.put(when + ".angles", {dJointGetUniversalAngle1(joint), dJointGetUniversalAngle2(joint), a1, a2});
    out.put(when + ".rates", {dJointGetUniversalAngle1Rate(joint), dJointGetUniversalAngle2Rate(joint)});
    put_params(out, when + ".params1", joint, &dJointGetUniversalParam, 0);
    put_params(out, when + ".params2", joint, &dJointGetUniversalParam, dParamGroup);
}

dJointID create_hinge2(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateHinge2(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = random.in_cube(1.0), n = random.direction(), m = perpendicular_to(n, random);
    const double lean = random.range(-0.5, 0.5);  // the two axes need not be perpendicular
    const double length = std::sqrt(1 + lean * lean);
    const dVector3 axis1 = {n.x, n.y, n.z, 0};
    const dVector3 axis2 = {(m.x + lean * n.x) / length, (m.y + lean * n.y) / length,
                            (m.z + lean * n.z) / length, 0};
    dJointSetHinge2Anchor(joint, p.x, p.y, p.z);
    dJointSetHinge2Axes(joint, axis1, axis2);
    return joint;
}

void put_hinge2(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor", joint, &dJointGetHinge2Anchor);
    put_vector(out, when + ".anchor2", joint, &dJointGetHinge2Anchor2);
    put_vector(out, when + ".axis1", joint, &dJointGetHinge2Axis1);
    put_vector(out, when + ".axis2", joint, &dJointGetHinge2Axis2);
    out.put(when + ".angles", {dJointGetHinge2Angle1(joint), dJointGetHinge2Angle2(joint)});
    out.put(when + ".rates", {dJointGetHinge2Angle1Rate(joint), dJointGetHinge2Angle2Rate(joint)});
    put_params(out, when + ".params1", joint, &dJointGetHinge2Param, 0);
    put_params(out, when + ".params2", joint, &dJointGetHinge2Param, dParamGroup);
    out.put(when + ".suspension", {dJointGetHinge2Param(joint, dParamSuspensionERP),
                                   dJointGetHinge2Param(joint, dParamSuspensionCFM)});
}

PARITY_CASE(step_universal)
{
    JointBench bench{create_universal, put_universal, limit_variants(&dJointSetUniversalParam, 0, "axis1-")};
    add_variants(bench.variants, limit_variants(&dJointSetUniversalParam, dParamGroup, "axis2-"));
    bench.variants.push_back({"both-motors", [](dJointID joint, Random& random) {
                                  for (const int group : {0, static_cast<int>(dParamGroup)}) {
                                      dJointSetUniversalParam(joint, dParamVel + group, random.range(-3, 3));
                                      dJointSetUniversalParam(joint, dParamFMax + group,
                                                              random.range(0.1, 200));
                                  }
                              }});
    bench.variants.push_back({"add-torques", [](dJointID joint, Random& random) {
                                  const Vec3 t = random.in_cube(5);
                                  dJointAddUniversalTorques(joint, t.x, t.y);
                              }});
    run_bench(out, rng, bench);
}

// Zero offsets of the angles. Both are kept only with two bodies attached (differences.tsv, D13).
PARITY_CASE(step_universal_offsets)
{
    JointBench bench{create_universal, put_universal, {}};
    bench.attachments = {Attach::kAB};
    bench.variants.push_back({"offsets", [](dJointID joint, Random& random) {
                                  dVector3 n = {0, 0, 0, 0};
                                  dJointGetUniversalAxis1(joint, n);
                                  dJointSetUniversalAxis1Offset(joint, n[0], n[1], n[2],
                                                                random.range(-0.5, 0.5),
                                                                random.range(-0.5, 0.5));
                              }});
    run_bench(out, rng, bench);
}

PARITY_CASE(step_hinge2)
{
    JointBench bench{create_hinge2, put_hinge2, limit_variants(&dJointSetHinge2Param, 0, "axis1-")};
    bench.attachments = two_body_attachments();
    add_variants(bench.variants, limit_variants(&dJointSetHinge2Param, dParamGroup, "axis2-"));
    bench.variants.push_back({"suspension", [](dJointID joint, Random& random) {
                                  dJointSetHinge2Param(joint, dParamSuspensionERP, random.range(0.1, 0.9));
                                  dJointSetHinge2Param(joint, dParamSuspensionCFM, random.range(1e-4, 1e-1));
                              }});
    bench.variants.push_back({"add-torques", [](dJointID joint, Random& random) {
                                  const Vec3 t = random.in_cube(5);
                                  dJointAddHinge2Torques(joint, t.x, t.y);
                              }});
    bench.variants.push_back(
        {"one-axis", [](dJointID joint, Random& random) {
             const Vec3 n = random.direction();
             dVector3 other = {0, 0, 0, 0};
             dJointGetHinge2Axis2(joint, other);
             const Vec3 p = perpendicular_to({other[0], other[1], other[2]}, random);
             const dVector3 axis = {p.x + 0.2 * n.x, p.y + 0.2 * n.y, p.z + 0.2 * n.z, 0};
             dJointSetHinge2Axes(joint, axis, nullptr);
         }});
    run_bench(out, rng, bench);
}

}  // namespace
}  // namespace parity
