// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rig.h. Poses are given to the library as quaternions, whose matrix it derives itself: the derived
// matrix is thereby compared too. Inertia tensors go through dMassSetParameters, which copies them.
#include "rig.h"

#include <cmath>
#include <cstdio>

namespace parity {

const char* attach_name(Attach attach)
{
    switch (attach) {
        case Attach::kAB:
            return "AB";
        case Attach::kBA:
            return "BA";
        case Attach::kA0:
            return "A0";
        case Attach::kOA:
            return "0A";
    }
    return "?";
}

std::vector<Attach> all_attachments() { return {Attach::kAB, Attach::kBA, Attach::kA0, Attach::kOA}; }

std::vector<Attach> two_body_attachments() { return {Attach::kAB, Attach::kBA}; }

void set_random_mass(dBodyID body, Random& random)
{
    const double total = random.range(0.5, 3.0);
    const double x = random.range(0.3, 1.2), y = random.range(0.3, 1.2), z = random.range(0.3, 1.2);
    const double principal[3] = {total / 12 * (y * y + z * z), total / 12 * (x * x + z * z),
                                 total / 12 * (x * x + y * y)};
    const Quat q = random.rotation(3.0);
    const Vec3 axes[3] = {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1})};
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
    for (int i = 0; i < 3; ++i) {
        const Vec3& e = axes[i];
        xx += principal[i] * e.x * e.x;
        yy += principal[i] * e.y * e.y;
        zz += principal[i] * e.z * e.z;
        xy += principal[i] * e.x * e.y;
        xz += principal[i] * e.x * e.z;
        yz += principal[i] * e.y * e.z;
    }
    dMass mass;
    dMassSetParameters(&mass, total, 0, 0, 0, xx, yy, zz, xy, xz, yz);
    dBodySetMass(body, &mass);
}

void set_random_pose(dBodyID body, Random& random, double half_side)
{
    const Vec3 p = random.in_cube(half_side);
    const Quat r = random.rotation(3.1);
    const dQuaternion q = {r.w, r.x, r.y, r.z};
    dBodySetPosition(body, p.x, p.y, p.z);
    dBodySetQuaternion(body, q);
}

Rig::Rig(Random& random, Attach attach)
    : world_(dWorldCreate()), a_(dBodyCreate(world_)), b_(nullptr), attach_(attach)
{
    static const double sizes[3] = {0.01, 0.002, 0.05};
    step_size_ = sizes[random.below(3)];
    if (attach == Attach::kAB || attach == Attach::kBA) { b_ = dBodyCreate(world_); }
    const Vec3 g = random.in_cube(10.0);
    dWorldSetGravity(world_, g.x, g.y, g.z);
    dWorldSetERP(world_, random.range(0.1, 0.9));
    dWorldSetCFM(world_, random.unit() < 0.5 ? 1e-10 : random.range(1e-6, 1e-3));
    for (const dBodyID body : {a_, b_}) {
        if (body != nullptr) {
            set_random_mass(body, random);
            set_random_pose(body, random, 1.0);
        }
    }
}

Rig::~Rig() { dWorldDestroy(world_); }

void Rig::attach(dJointID joint) const
{
    switch (attach_) {
        case Attach::kAB:
            dJointAttach(joint, a_, b_);
            break;
        case Attach::kBA:
            dJointAttach(joint, b_, a_);
            break;
        case Attach::kA0:
            dJointAttach(joint, a_, nullptr);
            break;
        case Attach::kOA:
            dJointAttach(joint, nullptr, a_);
            break;
    }
}

void Rig::disturb_body(dBodyID body, Random& random, double distance, double angle)
{
    const dReal* p = dBodyGetPosition(body);
    const Vec3 d = random.in_cube(distance);
    dBodySetPosition(body, p[0] + d.x, p[1] + d.y, p[2] + d.z);
    const dReal* old = dBodyGetQuaternion(body);
    const Quat turned = multiply(random.rotation(angle), {old[0], old[1], old[2], old[3]});
    const dQuaternion q = {turned.w, turned.x, turned.y, turned.z};
    dBodySetQuaternion(body, q);
}

// With two bodies each takes half of the disturbance, so that their relative motion stays in bounds.
void Rig::disturb(Random& random, double distance, double angle)
{
    const double share = b_ != nullptr ? 0.5 : 1.0;
    disturb_body(a_, random, distance * share, angle * share);
    if (b_ != nullptr) { disturb_body(b_, random, distance * share, angle * share); }
}

void Rig::push(Random& random, double speed)
{
    for (const dBodyID body : {a_, b_}) {
        if (body == nullptr) { continue; }
        const Vec3 v = random.in_cube(speed), w = random.in_cube(speed);
        const Vec3 f = random.in_cube(5.0), t = random.in_cube(2.0);
        dBodySetLinearVel(body, v.x, v.y, v.z);
        dBodySetAngularVel(body, w.x, w.y, w.z);
        dBodyAddForce(body, f.x, f.y, f.z);
        dBodyAddTorque(body, t.x, t.y, t.z);
    }
}

void shift(dBodyID body, const Vec3& by)
{
    const dReal* p = dBodyGetPosition(body);
    dBodySetPosition(body, p[0] + by.x, p[1] + by.y, p[2] + by.z);
}

void turn_around(dBodyID body, const Vec3& point, const Quat& q)
{
    const dReal *p = dBodyGetPosition(body), *old = dBodyGetQuaternion(body);
    const Quat turned = multiply(q, {old[0], old[1], old[2], old[3]});
    const Vec3 arm = rotate(q, {p[0] - point.x, p[1] - point.y, p[2] - point.z});
    const dQuaternion result = {turned.w, turned.x, turned.y, turned.z};
    dBodySetPosition(body, point.x + arm.x, point.y + arm.y, point.z + arm.z);
    dBodySetQuaternion(body, result);
}

void turn(dBodyID body, const Vec3& axis, double angle)
{
    const dReal* p = dBodyGetPosition(body);
    const double s = std::sin(angle / 2);
    turn_around(body, {p[0], p[1], p[2]}, {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z});
}

// The default CFM has a limit under so heavy bodies (difference D50); other numbers are literal in both libraries.
void stiffen(const Rig& rig)
{
    dWorldSetCFM(dBodyGetWorld(rig.a() != nullptr ? rig.a() : rig.b()), dReal(2e-10));
    for (const dBodyID body : {rig.a(), rig.b()}) {
        if (body == nullptr) { continue; }
        dMass mass;
        dBodyGetMass(body, &mass);
        const double huge = 1e20;
        dMassSetParameters(&mass, mass.mass, 0, 0, 0, huge, huge, huge, 0, 0, 0);
        dBodySetMass(body, &mass);
        dBodySetAngularVel(body, 0, 0, 0);
        dBodySetTorque(body, 0, 0, 0);
    }
}

void Rig::put_bodies(Output& out, const std::string& when) const
{
    out.put_body(when + ".A", a_);
    if (b_ != nullptr) { out.put_body(when + ".B", b_); }
}

void put_vector(Output& out, const std::string& key, dJointID joint, Get3 get)
{
    dVector3 v = {0, 0, 0, 0};
    get(joint, v);
    out.put(key, v, 3);
}

namespace {

void put_feedback(Output& out, const dJointFeedback& feedback)
{
    out.put("f1", feedback.f1, 3);
    out.put("t1", feedback.t1, 3);
    out.put("f2", feedback.f2, 3);
    out.put("t2", feedback.t2, 3);
}

void run_trial(Output& out, Random& random, const JointBench& bench, const JointVariant& variant,
               Attach attach)
{
    Rig rig(random, attach);
    const dJointID joint = bench.create(rig, random);
    rig.disturb(random, bench.distance, bench.angle);
    rig.push(random, 2.0);
    if (bench.settle) { bench.settle(rig, joint, random); }
    variant.set(joint, random);
    dJointFeedback feedback = {};
    dJointSetFeedback(joint, &feedback);
    bench.put_getters(out, "before", joint);
    if (bench.readings_only) { return; }
    out.put("step", {static_cast<double>(dWorldStep(rig.world(), rig.step_size()))});
    rig.put_bodies(out, "after");
    put_feedback(out, feedback);
    bench.put_getters(out, "after", joint);
}

}  // namespace

void run_bench(Output& out, Random& random, const JointBench& bench)
{
    for (const JointVariant& variant : bench.variants) {
        for (const Attach attach : bench.attachments) {
            for (int pose = 0; pose < bench.poses; ++pose) {
                char number[16];
                std::snprintf(number, sizeof number, "p%02d", pose);
                out.open_block(variant.name + "/" + attach_name(attach) + "/" + number);
                run_trial(out, random, bench, variant, attach);
            }
        }
    }
}

}  // namespace parity
