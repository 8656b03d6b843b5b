// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with a PU joint: two angles and a slide.
//
// Where the anchors have parted, the original lets each body feel the forces at its own anchor, which makes
// angular momentum out of nothing (D35). So the step_pu cases turn the bodies about the common anchor, and
// the slide is compared with too much inertia to turn. Attached as (0, B), the original takes the slide as a
// direction of the world (D11): that body is not turned.
#include "limit_states.h"

namespace parity {
namespace {

dJointID create_pu(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreatePU(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = random.in_cube(1.0), n = random.direction(), m = perpendicular_to(n, random),
               s = random.direction();
    dJointSetPUAnchor(joint, p.x, p.y, p.z);
    dJointSetPUAxis1(joint, n.x, n.y, n.z);
    dJointSetPUAxis2(joint, m.x, m.y, m.z);
    dJointSetPUAxis3(joint, s.x, s.y, s.z);
    return joint;
}

dJointID create_straight_pu(const Rig& rig, Random& random)
{
    static const dQuaternion identity = {1, 0, 0, 0};
    dBodySetQuaternion(rig.a(), identity);
    return create_pu(rig, random);
}

void put_pu(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor", joint, &dJointGetPUAnchor);
    put_vector(out, when + ".axis1", joint, &dJointGetPUAxis1);
    put_vector(out, when + ".axis2", joint, &dJointGetPUAxis2);
    put_vector(out, when + ".axis3", joint, &dJointGetPUAxis3);
    put_vector(out, when + ".axisP", joint, &dJointGetPUAxisP);
    dReal a1 = 0, a2 = 0;
    dJointGetPUAngles(joint, &a1, &a2);
    out.put(when + ".angles", {dJointGetPUAngle1(joint), dJointGetPUAngle2(joint), a1, a2});
    out.put(when + ".rates", {dJointGetPUAngle1Rate(joint), dJointGetPUAngle2Rate(joint)});
    out.put(when + ".position", {dJointGetPUPosition(joint)});
    out.put(when + ".slide-rate", {dJointGetPUPositionRate(joint)});
    for (int group = 0; group < 4; ++group) {
        put_params(out, when + ".params" + std::to_string(group + 1), joint, &dJointGetPUParam,
                   group * dParamGroup);
    }
}

void turn_about_anchor(const Rig& rig, dJointID joint, Random& random)
{
    dVector3 p = {0, 0, 0, 0};
    dJointGetPUAnchor(joint, p);
    for (const dBodyID body : {rig.a(), rig.b()}) {
        if (body != nullptr) { turn_around(body, {p[0], p[1], p[2]}, random.rotation(0.35)); }
    }
}

std::vector<JointVariant> turn_limits()
{
    std::vector<JointVariant> variants = limit_variants(&dJointSetPUParam, 0, "axis1-");
    add_variants(variants, limit_variants(&dJointSetPUParam, dParamGroup, "axis2-"));
    variants.push_back({"all-motors", [](dJointID joint, Random& random) {
                            for (int group = 0; group < 4; ++group) {
                                const int base = group * dParamGroup;
                                dJointSetPUParam(joint, dParamVel + base, random.range(-3, 3));
                                dJointSetPUParam(joint, dParamFMax + base, random.range(0.1, 200));
                            }
                        }});
    return variants;
}

std::vector<JointVariant> offsets()
{
    return {{"plain", [](dJointID, Random&) {}},
            {"anchor-offset",
             [](dJointID joint, Random& random) {
                 const Vec3 p = random.in_cube(1), d = random.in_cube(0.2);
                 dJointSetPUAnchorOffset(joint, p.x, p.y, p.z, d.x, d.y, d.z);
             }},
            {"anchor-delta",
             [](dJointID joint, Random& random) {
                 const Vec3 p = random.in_cube(1), d = random.in_cube(0.2);
                 dJointSetPUAnchorDelta(joint, p.x, p.y, p.z, d.x, d.y, d.z);
             }},
            {"axis-p", [](dJointID joint, Random& random) {
                 const Vec3 s = random.direction();
                 dJointSetPUAxisP(joint, s.x, s.y, s.z);
             }}};
}

PARITY_CASE(step_pu)
{
    JointBench bench{create_pu, put_pu, turn_limits()};
    bench.attachments = {Attach::kAB, Attach::kBA, Attach::kA0};
    bench.distance = bench.angle = 0;
    bench.settle = turn_about_anchor;
    run_bench(out, rng, bench);
}

PARITY_CASE(step_pu_slide)
{
    JointBench bench{create_pu, put_pu, limit_variants(&dJointSetPUParam, 2 * dParamGroup, "slide-")};
    add_variants(bench.variants, offsets());
    bench.attachments = {Attach::kAB, Attach::kBA, Attach::kA0};
    bench.distance = 0.35;
    bench.settle = [](const Rig& rig, dJointID, Random&) { stiffen(rig); };
    run_bench(out, rng, bench);
}

PARITY_CASE(step_pu_reversed_slide)
{
    JointBench bench{create_straight_pu, put_pu,
                     limit_variants(&dJointSetPUParam, 2 * dParamGroup, "slide-")};
    bench.attachments = {Attach::kOA};
    bench.distance = 0.35;
    bench.angle = 0;
    bench.settle = [](const Rig& rig, dJointID, Random&) { stiffen(rig); };
    run_bench(out, rng, bench);
}

PARITY_CASE(step_pu_readings)
{
    JointBench bench{create_pu, put_pu, offsets()};
    bench.readings_only = true;
    bench.distance = 0.35;
    run_bench(out, rng, bench);
}

}  // namespace
}  // namespace parity
