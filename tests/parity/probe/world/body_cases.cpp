// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies without joints: initial state, force functions, point and vector transforms, and one step of each
// way of integrating (rotation modes, gyroscopic term, damping, speed limit, kinematic, gravity mode).
#include "rig.h"

namespace parity {
namespace {

void put_accumulators(Output& out, const std::string& key, dBodyID b)
{
    out.put(key + ".force", dBodyGetForce(b), 3);
    out.put(key + ".torque", dBodyGetTorque(b), 3);
}

void put_flags(Output& out, const std::string& key, dBodyID b)
{
    out.put(key + ".flags",
            {static_cast<double>(dBodyIsEnabled(b)), static_cast<double>(dBodyIsKinematic(b)),
             static_cast<double>(dBodyGetGravityMode(b)), dBodyGetGyroscopicMode(b) != 0 ? 1.0 : 0.0,
             static_cast<double>(dBodyGetFiniteRotationMode(b)), static_cast<double>(dBodyGetNumJoints(b))});
    dVector3 axis = {0, 0, 0, 0};
    dBodyGetFiniteRotationAxis(b, axis);
    out.put(key + ".finite-axis", axis, 3);
    dMass mass;
    dBodyGetMass(b, &mass);
    out.put(key + ".mass", {mass.mass, mass.c[0], mass.c[1], mass.c[2]});
    out.put_matrix3(key + ".inertia", mass.I);
}

PARITY_CASE(body_initial_state)
{
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    out.put_body("new", body);
    out.put_matrix3("new.rot", dBodyGetRotation(body));
    put_accumulators(out, "new", body);
    put_flags(out, "new", body);
    out.put("links",
            {dBodyGetData(body) == nullptr ? 1.0 : 0.0, dBodyGetFirstGeom(body) == nullptr ? 1.0 : 0.0,
             dBodyGetWorld(body) == world ? 1.0 : 0.0});
    dWorldDestroy(world);
}

using ForceCall = void (*)(dBodyID, const Vec3& f, const Vec3& p);

PARITY_CASE(body_forces)
{
    const std::pair<const char*, ForceCall> calls[] = {
        {"force", [](dBodyID b, const Vec3& f, const Vec3&) { dBodyAddForce(b, f.x, f.y, f.z); }},
        {"torque", [](dBodyID b, const Vec3& f, const Vec3&) { dBodyAddTorque(b, f.x, f.y, f.z); }},
        {"rel-force", [](dBodyID b, const Vec3& f, const Vec3&) { dBodyAddRelForce(b, f.x, f.y, f.z); }},
        {"rel-torque", [](dBodyID b, const Vec3& f, const Vec3&) { dBodyAddRelTorque(b, f.x, f.y, f.z); }},
        {"at-pos", [](dBodyID b, const Vec3& f,
                      const Vec3& p) { dBodyAddForceAtPos(b, f.x, f.y, f.z, p.x, p.y, p.z); }},
        {"at-rel-pos", [](dBodyID b, const Vec3& f,
                          const Vec3& p) { dBodyAddForceAtRelPos(b, f.x, f.y, f.z, p.x, p.y, p.z); }},
        {"rel-at-pos", [](dBodyID b, const Vec3& f,
                          const Vec3& p) { dBodyAddRelForceAtPos(b, f.x, f.y, f.z, p.x, p.y, p.z); }},
        {"rel-at-rel-pos", [](dBodyID b, const Vec3& f,
                              const Vec3& p) { dBodyAddRelForceAtRelPos(b, f.x, f.y, f.z, p.x, p.y, p.z); }},
        {"set-force", [](dBodyID b, const Vec3& f, const Vec3&) { dBodySetForce(b, f.x, f.y, f.z); }},
        {"set-torque", [](dBodyID b, const Vec3& f, const Vec3&) { dBodySetTorque(b, f.x, f.y, f.z); }},
    };
    for (int pose = 0; pose < 20; ++pose) {
        const dWorldID world = dWorldCreate();
        const dBodyID body = dBodyCreate(world);
        set_random_mass(body, rng);
        set_random_pose(body, rng, 2.0);
        for (const auto& [name, call] : calls) {
            out.open_block(std::string(name) + "/p" + std::to_string(pose));
            call(body, rng.in_cube(3), rng.in_cube(3));
            put_accumulators(out, "sum", body);
        }
        dWorldStep(world, 0.01);
        out.put_body("stepped", body);
        put_accumulators(out, "stepped", body);
        dWorldDestroy(world);
    }
}

PARITY_CASE(body_transforms)
{
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    for (int pose = 0; pose < 30; ++pose) {
        out.open_block("p" + std::to_string(pose));
        set_random_pose(body, rng, 2.0);
        const Vec3 v = rng.in_cube(3), w = rng.in_cube(3), p = rng.in_cube(3);
        dBodySetLinearVel(body, v.x, v.y, v.z);
        dBodySetAngularVel(body, w.x, w.y, w.z);
        const auto put = [&](const char* key, void (*get)(dBodyID, dReal, dReal, dReal, dVector3)) {
            dVector3 r = {0, 0, 0, 0};
            get(body, p.x, p.y, p.z, r);
            out.put(key, r, 3);
        };
        put("rel-point-pos", dBodyGetRelPointPos);
        put("rel-point-vel", dBodyGetRelPointVel);
        put("point-vel", dBodyGetPointVel);
        put("pos-rel-point", dBodyGetPosRelPoint);
        put("to-world", dBodyVectorToWorld);
        put("from-world", dBodyVectorFromWorld);
        dMatrix3 R = {0};
        dBodyCopyRotation(body, R);
        out.put_matrix3("rotation", R);
        dBodySetRotation(body, R);
        out.put_body("set-rotation", body);
    }
    dWorldDestroy(world);
}

using BodySetting = void (*)(dBodyID, Random&);

PARITY_CASE(body_integration)
{
    const std::pair<const char*, BodySetting> settings[] = {
        {"plain", [](dBodyID, Random&) {}},
        {"finite", [](dBodyID b, Random&) { dBodySetFiniteRotationMode(b, 1); }},
        {"finite-slow",
         [](dBodyID b, Random&) {
             dBodySetFiniteRotationMode(b, 1);
             const dReal* w = dBodyGetAngularVel(b);
             dBodySetAngularVel(b, w[0] * 1e-4, w[1] * 1e-4, w[2] * 1e-4);
         }},
        {"finite-axis",
         [](dBodyID b, Random&) {
             // About the axis itself; across it the original advances by half a step (differences.tsv, D2).
             const dReal* w = dBodyGetAngularVel(b);
             dBodySetKinematic(b);
             dBodySetFiniteRotationMode(b, 1);
             dBodySetFiniteRotationAxis(b, 2 * w[0], 2 * w[1], 2 * w[2]);
         }},
        {"no-gyroscope", [](dBodyID b, Random&) { dBodySetGyroscopicMode(b, 0); }},
        {"no-gravity", [](dBodyID b, Random&) { dBodySetGravityMode(b, 0); }},
        {"max-speed", [](dBodyID b, Random&) { dBodySetMaxAngularSpeed(b, 3); }},
        {"damping", [](dBodyID b, Random& random) { dBodySetDamping(b, random.unit(), random.unit()); }},
        {"damping-threshold",
         [](dBodyID b, Random& random) {
             dBodySetDamping(b, random.unit(), random.unit());
             dBodySetLinearDampingThreshold(b, 4);
             dBodySetAngularDampingThreshold(b, 4);
         }},
        {"kinematic", [](dBodyID b, Random&) { dBodySetKinematic(b); }},
        {"dynamic-again",
         [](dBodyID b, Random&) {
             dBodySetKinematic(b);
             dBodySetDynamic(b);
         }},
        {"disabled", [](dBodyID b, Random&) { dBodyDisable(b); }},
        {"fast",
         [](dBodyID b, Random& random) {
             const Vec3 w = random.in_cube(100);
             dBodySetAngularVel(b, w.x, w.y, w.z);
         }},
    };
    for (const auto& [name, set] : settings) {
        for (int pose = 0; pose < 20; ++pose) {
            out.open_block(std::string(name) + "/p" + std::to_string(pose));
            Rig rig(rng, Attach::kA0);
            rig.push(rng, 5.0);
            set(rig.a(), rng);
            put_flags(out, "before", rig.a());
            dWorldStep(rig.world(), rig.step_size());
            rig.put_bodies(out, "exact");
            put_accumulators(out, "exact", rig.a());
            dWorldQuickStep(rig.world(), rig.step_size());
            rig.put_bodies(out, "quick");
            out.put_matrix3("quick.rot", dBodyGetRotation(rig.a()));
        }
    }
}

}  // namespace
}  // namespace parity
