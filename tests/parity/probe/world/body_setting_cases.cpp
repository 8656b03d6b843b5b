// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every setter of a body alone and read back at once: pose in each form, damping, auto-disable, speed limit,
// rotation mode, mass, data, copies of the pose, and the list of its geoms; and what each does in a step.
#include "rig.h"

#include <cmath>

namespace parity {
namespace {

double flag(bool value) { return value ? 1.0 : 0.0; }

void put_settings(Output& out, const std::string& key, dBodyID b)
{
    out.put(key + ".damping",
            {dBodyGetLinearDamping(b), dBodyGetAngularDamping(b), dBodyGetLinearDampingThreshold(b),
             dBodyGetAngularDampingThreshold(b), dBodyGetMaxAngularSpeed(b)});
    out.put(key + ".sleep",
            {static_cast<double>(dBodyGetAutoDisableFlag(b)), dBodyGetAutoDisableLinearThreshold(b),
             dBodyGetAutoDisableAngularThreshold(b), static_cast<double>(dBodyGetAutoDisableSteps(b)),
             dBodyGetAutoDisableTime(b), static_cast<double>(dBodyGetAutoDisableAverageSamplesCount(b))});
    out.put(key + ".flags",
            {flag(dBodyIsEnabled(b) != 0), flag(dBodyIsKinematic(b) != 0), flag(dBodyGetGravityMode(b) != 0),
             flag(dBodyGetGyroscopicMode(b) != 0), flag(dBodyGetFiniteRotationMode(b) != 0)});
    dVector3 axis = {0, 0, 0, 0};
    dBodyGetFiniteRotationAxis(b, axis);
    out.put(key + ".axis", axis, 3);
}

void put_copies(Output& out, const std::string& key, dBodyID b)
{
    dVector3 p = {5, 5, 5, 5};
    dQuaternion q = {5, 5, 5, 5};
    dMatrix3 R = {0};
    dBodyCopyPosition(b, p);
    dBodyCopyQuaternion(b, q);
    dBodyCopyRotation(b, R);
    out.put(key + ".position", p, 3);
    out.put(key + ".quaternion", q, 4);
    out.put_matrix3(key + ".rotation", R);
    const dReal *kept = dBodyGetPosition(b), *rows = dBodyGetRotation(b);
    out.put(key + ".flags", {flag(kept[0] == p[0] && kept[1] == p[1] && kept[2] == p[2]),
                             flag(rows[0] == R[0] && rows[5] == R[5] && rows[10] == R[10])});
}

using RealSetter = void (*)(dBodyID, dReal);

struct NamedSetter {
    const char* name;
    RealSetter set;
};

const NamedSetter kSetters[] = {
    {"linear-damping", dBodySetLinearDamping},
    {"angular-damping", dBodySetAngularDamping},
    {"linear-damping-threshold", dBodySetLinearDampingThreshold},
    {"angular-damping-threshold", dBodySetAngularDampingThreshold},
    {"max-angular-speed", dBodySetMaxAngularSpeed},
    {"sleep-linear-threshold", dBodySetAutoDisableLinearThreshold},
    {"sleep-angular-threshold", dBodySetAutoDisableAngularThreshold},
    {"sleep-time", dBodySetAutoDisableTime},
    {"sleep-steps",
     [](dBodyID b, dReal value) { dBodySetAutoDisableSteps(b, static_cast<int>(10 * value)); }},
    {"sleep-samples",
     [](dBodyID b, dReal value) {
         dBodySetAutoDisableAverageSamplesCount(b, static_cast<unsigned>(8 * value));
     }},
    {"sleep-flag", [](dBodyID b, dReal value) { dBodySetAutoDisableFlag(b, value > 0.4 ? 3 : 0); }},
    {"damping", [](dBodyID b, dReal value) { dBodySetDamping(b, value, 0.5 * value); }},
    {"gravity-mode", [](dBodyID b, dReal value) { dBodySetGravityMode(b, static_cast<int>(4 * value)); }},
    {"gyroscopic-mode",
     [](dBodyID b, dReal value) { dBodySetGyroscopicMode(b, static_cast<int>(4 * value)); }},
    {"finite-mode",
     [](dBodyID b, dReal value) { dBodySetFiniteRotationMode(b, static_cast<int>(4 * value)); }},
    {"finite-axis", [](dBodyID b, dReal value) { dBodySetFiniteRotationAxis(b, 0, value, 2 * value); }},
    {"damping-defaults", [](dBodyID b, dReal) { dBodySetDampingDefaults(b); }},
    {"sleep-defaults", [](dBodyID b, dReal) { dBodySetAutoDisableDefaults(b); }},
    {"disable", [](dBodyID b, dReal) { dBodyDisable(b); }},
    {"enable", [](dBodyID b, dReal) { dBodyEnable(b); }},
    {"kinematic", [](dBodyID b, dReal) { dBodySetKinematic(b); }},
    {"dynamic", [](dBodyID b, dReal) { dBodySetDynamic(b); }},
};

PARITY_CASE(body_settings)
{
    for (const NamedSetter& setter : kSetters) {
        for (const double value : {0.0, 0.3, 0.75, 1.0, 2.5}) {
            out.open_block(std::string(setter.name) + "/" + std::to_string(value));
            Rig rig(rng, Attach::kA0);
            rig.push(rng, 2.0);
            setter.set(rig.a(), value);
            put_settings(out, "set", rig.a());
            for (int i = 0; i < 3; ++i) { dWorldStep(rig.world(), rig.step_size()); }
            rig.put_bodies(out, "stepped");
            setter.set(rig.a(), 0.4 * value);
            put_settings(out, "again", rig.a());
        }
    }
}

// Settings after settings: the last one of a kind holds.
PARITY_CASE(body_setting_sequences)
{
    const int count = static_cast<int>(sizeof kSetters / sizeof kSetters[0]);
    for (int trial = 0; trial < 40; ++trial) {
        out.open_block("t" + std::to_string(trial));
        Rig rig(rng, Attach::kA0);
        dWorldSetLinearDamping(rig.world(), rng.unit());
        dWorldSetAngularDamping(rig.world(), rng.unit());
        rig.push(rng, 2.0);
        for (int i = 0; i < 25; ++i) {
            kSetters[rng.below(count)].set(rig.a(), rng.range(0, 1));
            put_settings(out, "s" + std::to_string(i), rig.a());
        }
        // Finite rotation about an axis: the original advances the rest by half a step (differences.tsv, D2).
        dBodySetFiniteRotationAxis(rig.a(), 0, 0, 0);
        dWorldStep(rig.world(), rig.step_size());
        rig.put_bodies(out, "stepped");
    }
}

PARITY_CASE(body_poses)
{
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    int mark = 0;
    dBodySetData(body, &mark);
    out.put("data.flags", {flag(dBodyGetData(body) == &mark), flag(dBodyGetWorld(body) == world)});
    for (int i = 0; i < 30; ++i) {
        out.open_block("p" + std::to_string(i));
        const Vec3 p = rng.in_cube(4);
        dBodySetPosition(body, p.x, p.y, p.z);
        const dQuaternion q = {rng.range(-2, 2), rng.range(-2, 2), rng.range(-2, 2), rng.range(-2, 2)};
        dBodySetQuaternion(body, q);
        put_copies(out, "quaternion", body);
        dMatrix3 R = {0};
        const Vec3 axis = rng.direction();
        dRFromAxisAndAngle(R, axis.x, axis.y, axis.z, i < 10 ? 3.14159265358979 : rng.range(-7, 7));
        dBodySetRotation(body, R);
        put_copies(out, "rotation", body);
        const Vec3 f = rng.in_cube(3), t = rng.in_cube(3);
        dBodySetForce(body, f.x, f.y, f.z);
        dBodySetTorque(body, t.x, t.y, t.z);
        dBodyAddRelForce(body, t.x, f.y, t.z);
        out.put("force", dBodyGetForce(body), 3);
        out.put("torque", dBodyGetTorque(body), 3);
    }
    dWorldDestroy(world);
}

// A body's geoms, last attached first, as they come, move to other bodies, and go.
PARITY_CASE(body_geoms)
{
    for (int trial = 0; trial < 20; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        const dBodyID bodies[3] = {dBodyCreate(world), dBodyCreate(world), nullptr};
        dGeomID geoms[8];
        for (dGeomID& g : geoms) { g = dCreateSphere(nullptr, 1); }
        for (int i = 0; i < 30; ++i) {
            dGeomSetBody(geoms[rng.below(8)], bodies[rng.below(3)]);
            if (rng.unit() < 0.2) {
                dGeomID& g = geoms[rng.below(8)];
                dGeomDestroy(g);
                g = dCreateSphere(nullptr, 1);
            }
        }
        const auto list = [&](dBodyID body, bool by_geom) {
            std::string text = "=";
            for (dGeomID g = dBodyGetFirstGeom(body); g != nullptr;
                 g = by_geom ? dGeomGetBodyNext(g) : dBodyGetNextGeom(g)) {
                for (int i = 0; i < 8; ++i) {
                    if (geoms[i] == g) { text += static_cast<char>('0' + i); }
                }
            }
            return text;
        };
        for (int i = 0; i < 2; ++i) {
            out.put_text("list" + std::to_string(i) + ".flags", list(bodies[i], false));
            out.put_text("next" + std::to_string(i) + ".flags", list(bodies[i], true));
        }
        dBodySetPosition(bodies[0], 1, 2, 3);
        dBodyDestroy(bodies[0]);
        for (const dGeomID g : geoms) {
            out.put("left",
                    {flag(dGeomGetBody(g) == nullptr), dGeomGetPosition(g)[0], dGeomGetPosition(g)[2]});
            dGeomDestroy(g);
        }
        dWorldDestroy(world);
    }
}

// A kinematic body moves by its velocity alone and pushes what it is joined to; made dynamic, it falls again.
PARITY_CASE(body_kinematic_runs)
{
    for (int trial = 0; trial < 10; ++trial) {
        out.open_block("t" + std::to_string(trial));
        Rig rig(rng, Attach::kAB);
        dBodySetKinematic(rig.a());
        rig.push(rng, 2.0);
        dBodySetPosition(rig.b(), 5, 0, 0);
        const dJointID joint = dJointCreateBall(rig.world(), nullptr);
        rig.attach(joint);
        const dReal* p = dBodyGetPosition(rig.b());
        dJointSetBallAnchor(joint, p[0], p[1] + 0.1, p[2]);
        if (trial % 2 == 1) {
            dBodySetDamping(rig.a(), 0.1, 0.2);
            dBodySetMaxAngularSpeed(rig.a(), 1);
        }
        for (int i = 0; i < 20; ++i) {
            dWorldStep(rig.world(), 0.01);
            dBodyAddForce(rig.a(), 100, 0, 0);
        }
        rig.put_bodies(out, "kinematic");
        dMass mass;
        dBodyGetMass(rig.a(), &mass);
        out.put("mass", {mass.mass});
        if (trial % 3 == 0) { dBodySetMass(rig.a(), &mass); }
        dBodySetDynamic(rig.a());
        out.put("now.flags", {flag(dBodyIsKinematic(rig.a()) != 0)});
        for (int i = 0; i < 20; ++i) { dWorldStep(rig.world(), 0.01); }
        rig.put_bodies(out, "dynamic");
    }
}

// Two kinematic bodies and the world: joints between them are no joints, and they do not make islands.
PARITY_CASE(body_kinematic_joints)
{
    for (int kind = 0; kind < 8; ++kind) {
        out.open_block("k" + std::to_string(kind));
        Rig rig(rng, Attach::kAB);
        const dBodyID sleeper = dBodyCreate(rig.world());
        dBodyDisable(sleeper);
        const dJointID first = dJointCreateHinge(rig.world(), nullptr),
                       second = dJointCreateNull(rig.world(), nullptr);
        dJointFeedback feedback = {};
        dJointSetFeedback(first, &feedback);
        dJointAttach(first, rig.a(), kind & 4 ? nullptr : rig.b());
        dJointAttach(second, rig.b(), sleeper);
        if (kind & 1) { dBodySetKinematic(rig.a()); }
        if (kind & 2) { dBodySetKinematic(rig.b()); }
        rig.push(rng, 1.0);
        dWorldStep(rig.world(), 0.01);
        rig.put_bodies(out, "after");
        out.put("after.flags", {flag(dBodyIsEnabled(sleeper) != 0)});
        out.put("f1", feedback.f1, 3);
        out.put("t2", feedback.t2, 3);
    }
}

}  // namespace
}  // namespace parity
