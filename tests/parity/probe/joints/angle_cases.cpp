// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Angle and rate readings over the full range of motion: three turns either way, both sides of +-pi, every
// pair of angles of a two-axis joint, poses where two axes nearly coincide, and motors that turn on for many
// turns. A joint is put at an angle exactly, by turning one body about the axis itself; the "leaning" trials
// add a random error of the constraint.
//
// At pi itself rounding decides the sign, so the nearest poses are 1e-9 off; a pose at pi is compared by sine
// and cosine.
#include "every_joint.h"

#include <cmath>

namespace parity {
namespace {

constexpr double kPi = 3.14159265358979323846;

Vec3 read(dJointID joint, Get3 get)
{
    dVector3 v = {0, 0, 0, 0};
    get(joint, v);
    return {v[0], v[1], v[2]};
}

std::vector<double> full_range()
{
    std::vector<double> angles;
    for (int i = -24; i <= 24; ++i) { angles.push_back(i * kPi / 8 + 0.01); }
    for (const double off : {1e-3, 1e-6, 1e-9}) {
        for (const double at : {-3 * kPi, -kPi, kPi, 3 * kPi}) {
            angles.push_back(at - off);
            angles.push_back(at + off);
        }
        angles.push_back(off);
        angles.push_back(-off);
    }
    return angles;
}

// Bodies move together to a new pose and get velocities: readings are relative.
void move_along(const Rig& rig, Random& random)
{
    const Quat q = random.rotation(3.0);
    const Vec3 centre = random.in_cube(1.0);
    if (rig.b() == nullptr) { return; }
    turn_around(rig.a(), centre, q);
    turn_around(rig.b(), centre, q);
}

struct Posed {
    Posed(const JointKind& kind, Attach attach, Random& random)
        : rig(random, attach), joint(kind.create(rig.world(), nullptr))
    {
        rig.attach(joint);
        place_at_random(kind, joint, random);
        move_along(rig, random);
        rig.push(random, 2.0);
    }
    Rig rig;
    dJointID joint;
};

PARITY_CASE(angle_one_axis)
{
    for (const JointKind& kind : every_joint()) {
        if (kind.first_axis == nullptr || kind.second_axis != nullptr) { continue; }
        for (const Attach attach : attachments_of(kind)) {
            for (const bool leaning : {false, true}) {
                out.open_block(std::string(kind.name) + "/" + attach_name(attach) +
                               (leaning ? "/leaning" : "/true"));
                Posed posed(kind, attach, rng);
                const Vec3 axis = read(posed.joint, kind.first_axis);
                double at = 0;
                if (leaning) { posed.rig.disturb(rng, 0.1, 0.2); }
                for (const double angle : full_range()) {
                    turn(posed.rig.a(), axis, angle - at);
                    at = angle;
                    kind.read(out, "at", posed.joint);
                }
            }
        }
    }
}

// Body A has one of the two axes: it is turned about its own first, then about the other body's.
PARITY_CASE(angle_two_axes)
{
    for (const JointKind& kind : every_joint()) {
        if (kind.second_axis == nullptr) { continue; }
        for (const Attach attach : attachments_of(kind)) {
            const bool first = attach == Attach::kAB || attach == Attach::kA0;
            for (const bool leaning : {false, true}) {
                out.open_block(std::string(kind.name) + "/" + attach_name(attach) +
                               (leaning ? "/leaning" : "/true"));
                Posed posed(kind, attach, rng);
                const Vec3 own = read(posed.joint, first ? kind.first_axis : kind.second_axis),
                           other = read(posed.joint, first ? kind.second_axis : kind.first_axis);
                if (leaning) { posed.rig.disturb(rng, 0.1, 0.2); }
                const dReal* p = dBodyGetPosition(posed.rig.a());
                const dReal* q = dBodyGetQuaternion(posed.rig.a());
                const dVector3 place = {p[0], p[1], p[2], 0};
                const dQuaternion start = {q[0], q[1], q[2], q[3]};
                for (int i = -9; i <= 9; ++i) {
                    for (int k = -9; k <= 9; ++k) {
                        dBodySetPosition(posed.rig.a(), place[0], place[1], place[2]);
                        dBodySetQuaternion(posed.rig.a(), start);
                        turn(posed.rig.a(), own, i * 0.37 + 0.001);
                        turn(posed.rig.a(), other, k * 0.41 - 0.002);
                        kind.read(out, "at", posed.joint);
                    }
                }
            }
        }
    }
}

// Axes that nearly coincide (a universal or Euler joint pressed into its singular pose), from 0.1 rad down to
// 1e-4 rad: angles lose what the geometry loses.
PARITY_CASE(angle_near_singular)
{
    for (const JointKind& kind : every_joint()) {
        if (kind.second_axis == nullptr) { continue; }
        for (const Attach attach : attachments_of(kind)) {
            for (const double off : {1e-1, 1e-2, 1e-3, 1e-4}) {
                out.open_block(std::string(kind.name) + "/" + attach_name(attach) + "/off" +
                               std::to_string(off));
                Posed posed(kind, attach, rng);
                const Vec3 n = read(posed.joint, kind.first_axis), m = read(posed.joint, kind.second_axis);
                const Vec3 across{n.y * m.z - n.z * m.y, n.z * m.x - n.x * m.z, n.x * m.y - n.y * m.x};
                turn(posed.rig.a(), across, rng.sign() * (kPi / 2 - off));
                kind.read(out, "near", posed.joint);
            }
        }
    }
}

struct EulerAngles {
    double first, second, third;
};

// The angles are those of the last step. A motor between kinematic bodies takes no part in it and keeps the
// angles it had before.
void put_euler(Output& out, Random& random, Attach attach, const EulerAngles& angles, bool kinematic)
{
    const Rig rig(random, attach);
    const dJointID joint = dJointCreateAMotor(rig.world(), nullptr);
    rig.attach(joint);
    const JointPlace place = random_place(random);
    dJointSetAMotorMode(joint, dAMotorEuler);
    dJointSetAMotorAxis(joint, 0, 1, place.n.x, place.n.y, place.n.z);
    dJointSetAMotorAxis(joint, 2, 2, place.k.x, place.k.y, place.k.z);
    for (const dBodyID body : {rig.a(), rig.b()}) {
        if (body != nullptr && kinematic) { dBodySetKinematic(body); }
    }
    turn(rig.a(), place.k, angles.third);
    turn(rig.a(), place.m, angles.second);
    turn(rig.a(), place.n, angles.first);
    dWorldStep(rig.world(), 1e-9);
    for (int i = 0; i < 3; ++i) {
        const std::string n = std::to_string(i);
        dVector3 axis = {0, 0, 0, 0};
        dJointGetAMotorAxis(joint, i, axis);
        out.put("at.vector" + n, axis, 3);
        out.put("at" + n + ".angles", {dJointGetAMotorAngle(joint, i)});
        out.put("at" + n + ".rates", {dJointGetAMotorAngleRate(joint, i)});
    }
}

PARITY_CASE(angle_euler)
{
    for (const Attach attach : all_attachments()) {
        for (int i = -8; i <= 8; i += 2) {
            for (int k = -3; k <= 3; ++k) {
                for (int m = -8; m <= 8; m += 2) {
                    out.open_block(std::string(attach_name(attach)) + "/" + std::to_string(i) + "." +
                                   std::to_string(k) + "." + std::to_string(m));
                    put_euler(out, rng, attach, {i * 0.41, k * 0.5, m * 0.39}, false);
                }
            }
        }
    }
}

PARITY_CASE(angle_euler_near_singular)
{
    for (const Attach attach : all_attachments()) {
        for (const double off : {1e-1, 1e-2, 1e-3, 1e-4, -1e-4, -1e-2}) {
            out.open_block(std::string(attach_name(attach)) + "/off" + std::to_string(off));
            const double first = rng.range(-3, 3), third = rng.range(-3, 3);
            put_euler(out, rng, attach, {first, rng.sign() * (kPi / 2 - off), third}, false);
        }
    }
}

PARITY_CASE(angle_euler_kinematic)
{
    for (const Attach attach : all_attachments()) {
        out.open_block(attach_name(attach));
        put_euler(out, rng, attach, {0.5, 0.4, -0.3}, true);
    }
}

// At pi itself.
PARITY_CASE(angle_at_pi)
{
    for (const JointKind& kind : every_joint()) {
        if (kind.first_axis == nullptr) { continue; }
        for (const Attach attach : attachments_of(kind)) {
            out.open_block(std::string(kind.name) + "/" + attach_name(attach));
            Posed posed(kind, attach, rng);
            turn(posed.rig.a(), read(posed.joint, kind.first_axis), kPi);
            const dJointType type = dJointGetType(posed.joint);
            const double angle = type == dJointTypeHinge    ? dJointGetHingeAngle(posed.joint)
                                 : type == dJointTypePiston ? dJointGetPistonAngle(posed.joint)
                                 : type == dJointTypePR     ? dJointGetPRAngle(posed.joint)
                                 : type == dJointTypePU     ? dJointGetPUAngle1(posed.joint)
                                 : type == dJointTypeHinge2 ? dJointGetHinge2Angle1(posed.joint)
                                                            : dJointGetUniversalAngle1(posed.joint);
            out.put("turned.angles", {std::sin(angle), std::cos(angle)});
        }
    }
}

// A motor that turns on and on: the angle read at every tenth of 600 steps, about four turns. (What the
// original's PR, PU and piston do off their centres is its own: differences.tsv, D10, D11, D34, D35.)
PARITY_CASE(run_turning)
{
    for (const JointKind& kind : every_joint()) {
        const std::string name = kind.name;
        if (name != "hinge" && name != "universal") { continue; }
        for (const Attach attach : {Attach::kAB, Attach::kA0, Attach::kOA}) {
            out.open_block(name + "/" + attach_name(attach));
            Rig rig(rng, attach);
            dWorldSetGravity(rig.world(), 0, 0, 0);
            const dJointID joint = kind.create(rig.world(), nullptr);
            rig.attach(joint);
            place_at_random(kind, joint, rng);
            kind.set(joint, dParamVel, 9.0);
            kind.set(joint, dParamFMax, 50.0);
            for (int i = 0; i < 600; ++i) {
                dWorldStep(rig.world(), 0.005);
                if (i % 10 == 0) { kind.read(out, "at", joint); }
            }
        }
    }
}

}  // namespace
}  // namespace parity
