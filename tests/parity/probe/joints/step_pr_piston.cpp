// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with a PR joint and with a piston: a slide and a turn with limits and motors each.
//
// Three bugs of the original are walked around (differences.tsv): PR between two bodies takes the arm of one
// row along the other body's axis (D34), so there the axes are left parallel; both joints attached as (0, B)
// take gap and arm with the wrong sign (D10), so there the anchor is at the centre of the body and either
// only turned about or, with too much inertia to turn, only slid along; what a PR's slide is driven or stopped
// by acts between centres (D45), so there both centres lie on the slide.
#include "limit_states.h"

namespace parity {
namespace {

Vec3 read(dJointID joint, Get3 get)
{
    dVector3 v = {0, 0, 0, 0};
    get(joint, v);
    return {v[0], v[1], v[2]};
}

Vec3 centre(dBodyID body)
{
    const dReal* x = dBodyGetPosition(body);
    return {x[0], x[1], x[2]};
}

// The anchor is at random, or at the centre of the only body.
Vec3 some_anchor(const Rig& rig, Random& random, bool centred)
{
    const Vec3 p = random.in_cube(1.0);
    return centred ? centre(rig.a()) : p;
}

dJointID create_pr_at(const Rig& rig, Random& random, bool centred)
{
    const dJointID joint = dJointCreatePR(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = some_anchor(rig, random, centred);
    const Vec3 n = random.direction(), m = perpendicular_to(n, random);
    dJointSetPRAnchor(joint, p.x, p.y, p.z);
    dJointSetPRAxis1(joint, n.x, n.y, n.z);
    dJointSetPRAxis2(joint, m.x, m.y, m.z);
    return joint;
}

dJointID create_pr(const Rig& rig, Random& random) { return create_pr_at(rig, random, false); }
dJointID create_pr_centred(const Rig& rig, Random& random) { return create_pr_at(rig, random, true); }

// The anchor is at the centre of body 2, or of the only body.
dJointID create_pr_on_its_slide(const Rig& rig, Random& random)
{
    const dJointID joint = create_pr(rig, random);
    const dBodyID second = dJointGetBody(joint, 1);
    const Vec3 p = centre(second ? second : rig.a());
    dJointSetPRAnchor(joint, p.x, p.y, p.z);
    return joint;
}

void put_pr(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor", joint, &dJointGetPRAnchor);
    put_vector(out, when + ".axis1", joint, &dJointGetPRAxis1);
    put_vector(out, when + ".axis2", joint, &dJointGetPRAxis2);
    out.put(when + ".position", {dJointGetPRPosition(joint)});
    out.put(when + ".slide-rate", {dJointGetPRPositionRate(joint)});
    out.put(when + ".angle", {dJointGetPRAngle(joint)});
    out.put(when + ".rate", {dJointGetPRAngleRate(joint)});
    put_params(out, when + ".params1", joint, &dJointGetPRParam, 0);
    put_params(out, when + ".params2", joint, &dJointGetPRParam, dParamGroup);
}

dJointID create_piston_at(const Rig& rig, Random& random, bool centred)
{
    const dJointID joint = dJointCreatePiston(rig.world(), nullptr);
    rig.attach(joint);
    const Vec3 p = some_anchor(rig, random, centred), n = random.direction();
    dJointSetPistonAnchor(joint, p.x, p.y, p.z);
    dJointSetPistonAxis(joint, n.x, n.y, n.z);
    return joint;
}

dJointID create_piston(const Rig& rig, Random& random) { return create_piston_at(rig, random, false); }
dJointID create_piston_centred(const Rig& rig, Random& random) { return create_piston_at(rig, random, true); }

void put_piston(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor", joint, &dJointGetPistonAnchor);
    put_vector(out, when + ".anchor2", joint, &dJointGetPistonAnchor2);
    put_vector(out, when + ".axis", joint, &dJointGetPistonAxis);
    out.put(when + ".position", {dJointGetPistonPosition(joint)});
    out.put(when + ".angle", {dJointGetPistonAngle(joint)});
    out.put(when + ".rates", {dJointGetPistonPositionRate(joint), dJointGetPistonAngleRate(joint)});
    put_params(out, when + ".params1", joint, &dJointGetPistonParam, 0);
    put_params(out, when + ".params2", joint, &dJointGetPistonParam, dParamGroup);
}

JointVariant both_motors(SetParam set)
{
    return {"both-motors", [set](dJointID joint, Random& random) {
                for (const int group : {0, static_cast<int>(dParamGroup)}) {
                    set(joint, dParamVel + group, random.range(-3, 3));
                    set(joint, dParamFMax + group, random.range(0.1, 200));
                }
            }};
}

std::vector<JointVariant> both_limits(SetParam set)
{
    std::vector<JointVariant> variants = limit_variants(set, 0, "slide-");
    add_variants(variants, limit_variants(set, dParamGroup, "turn-"));
    variants.push_back(both_motors(set));
    return variants;
}

JointVariant pr_torque()
{
    return {"add-torque",
            [](dJointID joint, Random& random) { dJointAddPRTorque(joint, random.range(-5, 5)); }};
}

JointVariant plain()
{
    return {"plain", [](dJointID, Random&) {}};
}

// Attached as (0, B): both joints with the anchor in the centre of the body.
JointBench reversed_bench(const JointBench& like, Get3 slide, Get3 axis, SetParam set, bool sliding)
{
    JointBench bench = like;
    bench.attachments = {Attach::kOA};
    bench.distance = bench.angle = 0;
    bench.variants = limit_variants(set, sliding ? 0 : dParamGroup, sliding ? "slide-" : "turn-");
    bench.settle = [=](const Rig& rig, dJointID joint, Random& random) {
        const double amount = random.range(-0.7, 0.7);
        const Vec3 s = read(joint, slide);
        if (!sliding) { return turn(rig.a(), read(joint, axis), amount); }
        shift(rig.a(), {amount * s.x, amount * s.y, amount * s.z});
        stiffen(rig);
    };
    return bench;
}

void turn_both(const Rig&, dJointID joint, Random& random)
{
    const Vec3 axis = read(joint, &dJointGetPRAxis2);
    for (const int which : {0, 1})
        if (const dBodyID body = dJointGetBody(joint, which)) turn(body, axis, random.range(-0.35, 0.35));
}

// Turned, and then body 1 is put anywhere on its slide, which turns with it.
void slide_first(const Rig& rig, dJointID joint, Random& random)
{
    turn_both(rig, joint, random);
    const dBodyID first = dJointGetBody(joint, 0), second = dJointGetBody(joint, 1);
    const Vec3 s = read(joint, &dJointGetPRAxis1), from = centre(second ? second : first);
    const double amount = random.range(-0.7, 0.7);
    dBodySetPosition(first, from.x + amount * s.x, from.y + amount * s.y, from.z + amount * s.z);
}

JointBench pr_sliding(std::vector<Attach> attachments)
{
    JointBench bench{create_pr_on_its_slide, put_pr, limit_variants(&dJointSetPRParam, 0, "slide-")};
    bench.attachments = std::move(attachments);
    bench.variants.push_back(both_motors(&dJointSetPRParam));
    bench.distance = bench.angle = 0;
    bench.settle = slide_first;
    return bench;
}

JointBench pr_turning(std::vector<Attach> attachments)
{
    JointBench bench{create_pr, put_pr, limit_variants(&dJointSetPRParam, dParamGroup, "turn-")};
    bench.attachments = std::move(attachments);
    bench.variants.push_back(pr_torque());
    bench.distance = 0.35;
    return bench;
}

PARITY_CASE(step_pr_world)
{
    run_bench(out, rng, pr_sliding({Attach::kA0}));
    run_bench(out, rng, pr_turning({Attach::kA0}));
}

PARITY_CASE(step_pr)
{
    run_bench(out, rng, pr_sliding(two_body_attachments()));
    JointBench turning = pr_turning(two_body_attachments());
    turning.angle = 0;
    turning.settle = turn_both;
    run_bench(out, rng, turning);
}

PARITY_CASE(step_pr_reversed)
{
    const JointBench like{create_pr_centred, put_pr, {}};
    for (const bool sliding : {true, false}) {
        JointBench bench =
            reversed_bench(like, &dJointGetPRAxis1, &dJointGetPRAxis2, &dJointSetPRParam, sliding);
        if (!sliding) { bench.variants.push_back(pr_torque()); }
        run_bench(out, rng, bench);
    }
}

PARITY_CASE(step_pr_readings)
{
    JointBench bench{create_pr, put_pr, {plain()}};
    bench.readings_only = true;
    run_bench(out, rng, bench);
}

PARITY_CASE(step_piston)
{
    JointBench bench{create_piston, put_piston, both_limits(&dJointSetPistonParam)};
    bench.attachments = {Attach::kAB, Attach::kBA, Attach::kA0};
    bench.distance = 0.35;
    bench.variants.push_back({"anchor-offset", [](dJointID joint, Random& random) {
                                  const Vec3 p = random.in_cube(1), d = random.in_cube(0.2);
                                  dJointSetPistonAnchorOffset(joint, p.x, p.y, p.z, d.x, d.y, d.z);
                              }});
    bench.variants.push_back({"axis-delta", [](dJointID joint, Random& random) {
                                  const Vec3 n = random.direction(), d = random.in_cube(0.2);
                                  dJointSetPistonAxisDelta(joint, n.x, n.y, n.z, d.x, d.y, d.z);
                              }});
    run_bench(out, rng, bench);
}

PARITY_CASE(step_piston_reversed)
{
    const JointBench like{create_piston_centred, put_piston, {}};
    for (const bool sliding : {true, false}) {
        run_bench(
            out, rng,
            reversed_bench(like, &dJointGetPistonAxis, &dJointGetPistonAxis, &dJointSetPistonParam, sliding));
    }
}

PARITY_CASE(step_piston_readings)
{
    JointBench bench{create_piston, put_piston, {plain()}};
    bench.readings_only = true;
    bench.variants.push_back({"anchor-offset", [](dJointID joint, Random& random) {
                                  const Vec3 p = random.in_cube(1), d = random.in_cube(0.2);
                                  dJointSetPistonAnchorOffset(joint, p.x, p.y, p.z, d.x, d.y, d.z);
                              }});
    bench.variants.push_back({"axis-delta", [](dJointID joint, Random& random) {
                                  const Vec3 n = random.direction(), d = random.in_cube(0.2);
                                  dJointSetPistonAxisDelta(joint, n.x, n.y, n.z, d.x, d.y, d.z);
                              }});
    run_bench(out, rng, bench);
}

// A force at the anchor of each body. The original turns body 2 the wrong way (D12): its anchor is at its
// centre.
PARITY_CASE(step_piston_force)
{
    JointBench bench{create_piston, put_piston, {}};
    bench.attachments = {Attach::kAB, Attach::kBA, Attach::kA0};
    bench.variants.push_back({"add-force", [](dJointID joint, Random& random) {
                                  if (const dBodyID second = dJointGetBody(joint, 1)) {
                                      const dReal* p = dBodyGetPosition(second);
                                      dJointSetPistonAnchor(joint, p[0], p[1], p[2]);
                                  }
                                  dJointAddPistonForce(joint, random.range(-5, 5));
                              }});
    run_bench(out, rng, bench);
}

}  // namespace
}  // namespace parity
