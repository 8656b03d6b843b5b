// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Transmissions in their three modes: one dWorldStep between free bodies in random poses, where slip is zero
// by definition, and 100 steps of wheels on hinges, where it has to stay so.
//
// Intended differences (differences.tsv) keep the cases to gears that work in both: anchors level and axes
// parallel or perpendicular (D36), bevel gears with the one sign of slip that the original knows (D37),
// chains along the x axis of the world from its origin (D38), ratio and radii set before the first step
// (D39).
#include "limit_states.h"

namespace parity {
namespace {

struct Frame {
    Vec3 n, d, m;  // axis, from wheel to wheel, and n x d
};

Frame random_frame(Random& random)
{
    const Vec3 n = random.direction(), d = perpendicular_to(n, random);
    return {n, d, {n.y * d.z - n.z * d.y, n.z * d.x - n.x * d.z, n.x * d.y - n.y * d.x}};
}

Vec3 along(const Vec3& p, double s, const Vec3& d) { return {p.x + s * d.x, p.y + s * d.y, p.z + s * d.z}; }

void set_anchors(dJointID joint, const Vec3& p, const Vec3& q)
{
    dJointSetTransmissionAnchor1(joint, p.x, p.y, p.z);
    dJointSetTransmissionAnchor2(joint, q.x, q.y, q.z);
}

dJointID create_parallel(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateTransmission(rig.world(), nullptr);
    rig.attach(joint);
    const Frame f = random_frame(random);
    const Vec3 p = random.in_cube(1.0);
    dJointSetTransmissionAxis(joint, f.n.x, f.n.y, f.n.z);
    set_anchors(joint, p, along(p, random.range(0.5, 2), f.d));
    dJointSetTransmissionRatio(joint, random.range(0.3, 3));
    return joint;
}

dJointID create_chain(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateTransmission(rig.world(), nullptr);
    rig.attach(joint);
    dJointSetTransmissionMode(joint, dTransmissionChainDrive);
    static const dQuaternion identity = {1, 0, 0, 0};
    for (const dBodyID body : {rig.a(), rig.b()}) { dBodySetQuaternion(body, identity); }
    dJointSetTransmissionAxis(joint, 0, 0, random.sign());
    set_anchors(joint, {0, 0, 0}, {random.range(1, 2), 0, 0});
    // Equal radii make the first slip exactly zero, whose rounding would choose the original's side.
    const double radius = random.range(0.1, 0.7);
    dJointSetTransmissionRadius1(joint, radius);
    dJointSetTransmissionRadius2(joint, radius);
    return joint;
}

dJointID create_bevel(const Rig& rig, Random& random)
{
    const dJointID joint = dJointCreateTransmission(rig.world(), nullptr);
    rig.attach(joint);
    dJointSetTransmissionMode(joint, dTransmissionIntersectingAxes);
    const Frame f = random_frame(random);
    const Vec3 p = random.in_cube(1.0), contact = along(p, random.range(0.5, 2), f.d);
    // Barely acute, so that no rounding turns axis 1 round.
    const double lean = 1e-6;
    dJointSetTransmissionAxis1(joint, f.n.x, f.n.y, f.n.z);
    dJointSetTransmissionAxis2(joint, f.d.x + lean * f.n.x, f.d.y + lean * f.n.y, f.d.z + lean * f.n.z);
    set_anchors(joint, p, along(contact, random.range(0.5, 2), f.n));
    return joint;
}

void put_settings(Output& out, const std::string& when, dJointID joint)
{
    put_vector(out, when + ".anchor1", joint, &dJointGetTransmissionAnchor1);
    put_vector(out, when + ".anchor2", joint, &dJointGetTransmissionAnchor2);
    put_vector(out, when + ".axis1", joint, &dJointGetTransmissionAxis1);
    put_vector(out, when + ".axis2", joint, &dJointGetTransmissionAxis2);
    out.put(when + ".mode", {static_cast<double>(dJointGetTransmissionMode(joint))});
    out.put(when + ".ratio", {dJointGetTransmissionRatio(joint)});
    out.put(when + ".backlash", {dJointGetTransmissionBacklash(joint)});
    out.put(when + ".radii", {dJointGetTransmissionRadius1(joint), dJointGetTransmissionRadius2(joint)});
    out.put(when + ".own",
            {dJointGetTransmissionParam(joint, dParamERP), dJointGetTransmissionParam(joint, dParamCFM),
             dJointGetTransmissionParam(joint, dParamLoStop)});
}

// Before the first step the original has not filled in the rest.
void put_angles(Output& out, const std::string& when, dJointID joint)
{
    put_settings(out, when, joint);
    if (when == "before") { return; }
    out.put(when + ".angles", {dJointGetTransmissionAngle1(joint), dJointGetTransmissionAngle2(joint)});
}

void put_transmission(Output& out, const std::string& when, dJointID joint)
{
    put_angles(out, when, joint);
    if (when == "before") { return; }
    put_vector(out, when + ".contact1", joint, &dJointGetTransmissionContactPoint1);
    put_vector(out, when + ".contact2", joint, &dJointGetTransmissionContactPoint2);
    if (dJointGetTransmissionMode(joint) == dTransmissionParallelAxes) {
        put_vector(out, when + ".axis", joint, &dJointGetTransmissionAxis);
    }
}

// The second body moves without turning and not along the axis: axes stay parallel and anchors level.
void slide_across(const Rig& rig, dJointID joint, Random& random)
{
    dVector3 n = {0, 0, 0, 0};
    dJointGetTransmissionAxis1(joint, n);
    const Vec3 d = random.in_cube(0.2);
    const double height = n[0] * d.x + n[1] * d.y + n[2] * d.z;
    shift(rig.b(), along(d, -height, {n[0], n[1], n[2]}));
}

std::vector<JointVariant> variants()
{
    return {{"plain", [](dJointID, Random&) {}},
            {"soft",
             [](dJointID joint, Random& random) {
                 dJointSetTransmissionParam(joint, dParamERP, random.range(0.1, 0.9));
                 dJointSetTransmissionParam(joint, dParamCFM, random.range(1e-4, 1e-1));
             }},
            {"play", [](dJointID joint, Random& random) {
                 dJointSetTransmissionBacklash(joint, random.range(0.01, 0.1));
             }}};
}

void run_transmission(Output& out, Random& random, dJointID (*create)(const Rig&, Random&), bool slide)
{
    JointBench bench{create, put_transmission, variants()};
    bench.attachments = two_body_attachments();
    bench.distance = bench.angle = 0;
    if (slide) { bench.settle = slide_across; }
    run_bench(out, random, bench);
}

PARITY_CASE(step_transmission_parallel) { run_transmission(out, rng, create_parallel, true); }
PARITY_CASE(step_transmission_chain) { run_transmission(out, rng, create_chain, false); }
PARITY_CASE(step_transmission_bevel) { run_transmission(out, rng, create_bevel, true); }

// ---- 100 steps of two wheels on hinges ----

struct Gears {
    dWorldID world = dWorldCreate();
    dBodyID wheel[2] = {dBodyCreate(world), dBodyCreate(world)};
    dJointID hinge[2] = {dJointCreateHinge(world, nullptr), dJointCreateHinge(world, nullptr)};
    dJointID joint = dJointCreateTransmission(world, nullptr);

    Gears() = default;
    ~Gears() { dWorldDestroy(world); }
    Gears(const Gears&) = delete;
    Gears& operator=(const Gears&) = delete;

    void place(int i, const Vec3& p, const Vec3& n)
    {
        dBodySetPosition(wheel[i], p.x, p.y, p.z);
        dJointAttach(hinge[i], wheel[i], nullptr);
        dJointSetHingeAnchor(hinge[i], p.x, p.y, p.z);
        dJointSetHingeAxis(hinge[i], n.x, n.y, n.z);
    }
    void drive(double speed, double force) const
    {
        dJointSetHingeParam(hinge[0], dParamVel, speed);
        dJointSetHingeParam(hinge[0], dParamFMax, force);
        dJointSetHingeParam(hinge[1], dParamFMax, 0.2 * force);  // a brake
    }
};

void run_gears(Output& out, Gears& gears, bool contacts)
{
    dBodySetAngularVel(gears.wheel[0], 0, 0, 3);
    for (int i = 0; i < 100; ++i) { dWorldStep(gears.world, 0.01); }
    for (int i = 0; i < 2; ++i) {
        const std::string wheel = "wheel" + std::to_string(i);
        out.put(wheel + ".angle", {dJointGetHingeAngle(gears.hinge[i])});
        out.put(wheel + ".rate", {dJointGetHingeAngleRate(gears.hinge[i])});
    }
    contacts ? put_transmission(out, "end", gears.joint) : put_angles(out, "end", gears.joint);
}

struct Trial {
    const char* name;
    double speed, backlash;
};

constexpr Trial kTrials[] = {{"slow", 2, 0}, {"fast", -9, 0}, {"play", 2, 0.05}};

PARITY_CASE(run_gears_parallel)
{
    for (const Trial& trial : kTrials) {
        out.open_block(trial.name);
        Gears g;
        g.place(0, {0, 0, 0}, {0, 0, 1});
        g.place(1, {1.8, 2.4, 0}, {0, 0, 1});
        g.drive(trial.speed, 5);
        dJointAttach(g.joint, g.wheel[0], g.wheel[1]);
        dJointSetTransmissionAxis(g.joint, 0, 0, 1);
        dJointSetTransmissionRatio(g.joint, 2.5);
        dJointSetTransmissionBacklash(g.joint, trial.backlash);
        run_gears(out, g, true);
    }
}

PARITY_CASE(run_gears_chain)
{
    for (const Trial& trial : kTrials) {
        out.open_block(trial.name);
        Gears g;
        g.place(0, {0, 0, 0}, {0, 0, 1});
        g.place(1, {3, 0, 0}, {0, 0, 1});
        g.drive(trial.speed, 5);
        dJointAttach(g.joint, g.wheel[0], g.wheel[1]);
        dJointSetTransmissionMode(g.joint, dTransmissionChainDrive);
        dJointSetTransmissionAxis(g.joint, 0, 0, 1);
        dJointSetTransmissionRadius1(g.joint, 0.7);
        dJointSetTransmissionRadius2(g.joint, 0.4);
        dJointSetTransmissionBacklash(g.joint, trial.backlash);
        run_gears(out, g, false);
    }
}

PARITY_CASE(run_gears_bevel)
{
    for (const Trial& trial : kTrials) {
        out.open_block(trial.name);
        Gears g;
        g.place(0, {0, 0, 0}, {0, 0, 1});
        g.place(1, {2, 0, 3}, {-1, 0, 0});
        g.drive(trial.speed, 5);
        dJointAttach(g.joint, g.wheel[0], g.wheel[1]);
        dJointSetTransmissionMode(g.joint, dTransmissionIntersectingAxes);
        dJointSetTransmissionAxis1(g.joint, 0, 0, 1);
        dJointSetTransmissionAxis2(g.joint, -1, 0, 0);
        dJointSetTransmissionBacklash(g.joint, trial.backlash);
        run_gears(out, g, true);
    }
}

}  // namespace
}  // namespace parity
