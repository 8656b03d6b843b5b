// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldExportDIF of worlds with every setting, kind of body, geom and joint that Debian's library can write,
// read back and compared field by field. Left out is what it cannot write (differences D44).
#include "dif_reader.h"
#include "rig.h"

#include <cmath>

namespace parity {
namespace {

PARITY_CASE(dif_world)
{
    for (int i = 0; i < 10; ++i) {
        out.open_block("t" + std::to_string(i));
        const dWorldID w = dWorldCreate();
        dWorldSetGravity(w, rng.range(-9, 9), rng.range(-9, 9), rng.range(-9, 9));
        dWorldSetERP(w, rng.range(0, 1));
        dWorldSetCFM(w, rng.range(0, 1e-3));
        dWorldSetAutoDisableLinearThreshold(w, rng.range(0, 1));
        dWorldSetAutoDisableAngularThreshold(w, rng.range(0, 1));
        dWorldSetAutoDisableSteps(w, rng.below(50));
        dWorldSetAutoDisableTime(w, rng.range(0, 2));
        dWorldSetAutoDisableAverageSamplesCount(w, static_cast<unsigned>(1 + rng.below(5)));
        put_dif(out, exported(w, i % 2 ? "" : "my_"));
        dWorldDestroy(w);
    }
}

void add_geoms(dSpaceID space, dBodyID body, Random& random)
{
    for (int n = random.below(4); n > 0; --n) {
        const double a = random.range(0.1, 2), b = random.range(0.1, 2), c = random.range(0.1, 2);
        dGeomID geom = nullptr;
        switch (random.below(5)) {
            case 0:
                geom = dCreateSphere(space, a);
                break;
            case 1:
                geom = dCreateBox(space, a, b, c);
                break;
            case 2:
                geom = dCreateCapsule(space, a, b);
                break;
            case 3:
                geom = dCreateCylinder(space, a, b);
                break;
            default:
                geom = dCreateRay(space, a);
        }
        dGeomSetBody(geom, body);
        if (random.below(3) == 0) {
            dGeomSetCategoryBits(geom, static_cast<unsigned long>(random.below(1000)));
        }
        if (random.below(3) == 0) { dGeomSetCollideBits(geom, 0xffffffffUL); }
        if (random.below(3) == 0) { dGeomDisable(geom); }
        if (random.below(3) == 0) { dGeomSetOffsetPosition(geom, a, b, c); }
    }
}

void set_behaviour(dBodyID body, Random& random)
{
    if (random.below(3) == 0) { dBodySetFiniteRotationMode(body, 1); }
    if (random.below(3) == 0) {
        const Vec3 d = random.direction();
        dBodySetFiniteRotationAxis(body, d.x, d.y, d.z);
    }
    if (random.below(3) == 0) { dBodySetGravityMode(body, 0); }
    if (random.below(3) == 0) {
        dBodySetAutoDisableFlag(body, 1);
        dBodySetAutoDisableTime(body, random.range(0, 3));
        dBodySetAutoDisableSteps(body, random.below(30));
        dBodySetAutoDisableLinearThreshold(body, random.range(0, 1));
        dBodyDisable(body);
        dBodyEnable(body);
    }
    if (random.below(3) == 0) { dBodyAddForce(body, random.range(1, 9), random.range(1, 9), -1); }
    if (random.below(3) == 0) { dBodyAddTorque(body, random.range(1, 9), random.range(1, 9), -1); }
    if (random.below(4) == 0) { dBodyDisable(body); }
}

PARITY_CASE(dif_bodies)
{
    for (int i = 0; i < 20; ++i) {
        out.open_block("t" + std::to_string(i));
        const dWorldID w = dWorldCreate();
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        for (int k = 0; k < 4; ++k) {
            const dBodyID body = dBodyCreate(w);
            const Vec3 v = rng.in_cube(3), o = rng.in_cube(3);
            set_random_mass(body, rng);
            set_random_pose(body, rng, 5);
            dBodySetLinearVel(body, v.x, v.y, v.z);
            dBodySetAngularVel(body, o.x, o.y, o.z);
            set_behaviour(body, rng);
            add_geoms(space, body, rng);
        }
        put_dif(out, exported(w, "w"));
        dSpaceDestroy(space);
        dWorldDestroy(w);
    }
}

PARITY_CASE(dif_contacts)
{
    const int bits[] = {dContactMu2,     dContactFDir1,     dContactBounce,   dContactSoftERP,
                        dContactSoftCFM, dContactMotion1,   dContactMotion2,  dContactSlip1,
                        dContactSlip2,   dContactApprox1_1, dContactApprox1_2};
    const dWorldID w = dWorldCreate();
    const dBodyID a = dBodyCreate(w), b = dBodyCreate(w);
    for (int i = 0; i < 40; ++i) {
        dContact c = {};
        for (const int bit : bits) {
            if (rng.below(2)) { c.surface.mode |= bit; }
        }
        dReal* const numbers[] = {&c.surface.mu,       &c.surface.mu2,      &c.surface.bounce,
                                  &c.surface.soft_erp, &c.surface.soft_cfm, &c.surface.bounce_vel,
                                  &c.surface.motion1,  &c.surface.motion2,  &c.surface.slip1,
                                  &c.surface.slip2,    &c.geom.depth};
        for (dReal* x : numbers) { *x = rng.range(0.01, 1); }
        const Vec3 p = rng.in_cube(2), n = rng.direction(), f = perpendicular_to(n, rng);
        c.geom.pos[0] = p.x, c.geom.pos[1] = p.y, c.geom.pos[2] = p.z;
        c.geom.normal[0] = n.x, c.geom.normal[1] = n.y, c.geom.normal[2] = n.z;
        c.fdir1[0] = f.x, c.fdir1[1] = f.y, c.fdir1[2] = f.z;
        const dJointID joint = dJointCreateContact(w, nullptr, &c);
        dJointAttach(joint, i % 3 ? a : nullptr, i % 3 == 1 ? nullptr : b);
    }
    put_dif(out, exported(w, "c"));
    dWorldDestroy(w);
}

void set_params(dJointID joint, Random& random, void (*set)(dJointID, int, dReal), int groups)
{
    const int params[] = {dParamVel, dParamFMax,    dParamFudgeFactor, dParamBounce,
                          dParamCFM, dParamStopERP, dParamStopCFM};
    for (int group = 0; group < groups; ++group) {
        const int first = group * dParamGroup;
        set(joint, first + dParamLoStop, random.range(-2, -1));
        set(joint, first + dParamHiStop, random.range(1, 2));
        for (const int param : params) {
            if (random.below(2)) { set(joint, first + param, random.range(0.1, 0.9)); }
        }
    }
}

struct Placement {
    Vec3 p, a1, a2, a3;  // a point and three perpendicular directions
};

Placement random_placement(Random& random)
{
    Placement at;
    at.p = random.in_cube(2);
    at.a1 = random.direction();
    at.a2 = perpendicular_to(at.a1, random);
    at.a3 = {at.a1.y * at.a2.z - at.a1.z * at.a2.y, at.a1.z * at.a2.x - at.a1.x * at.a2.z,
             at.a1.x * at.a2.y - at.a1.y * at.a2.x};
    return at;
}

struct Kind {
    const char* name;
    dJointID (*create)(dWorldID, dJointGroupID);
    bool two_bodies;
    void (*set)(dJointID, const Placement&, Random&);
};

const Kind kinds[] = {
    {"ball", dJointCreateBall, false,
     [](dJointID j, const Placement& at, Random&) { dJointSetBallAnchor(j, at.p.x, at.p.y, at.p.z); }},
    {"hinge", dJointCreateHinge, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetHingeAnchor(j, at.p.x, at.p.y, at.p.z);
         dJointSetHingeAxis(j, at.a1.x, at.a1.y, at.a1.z);
         set_params(j, random, dJointSetHingeParam, 1);
     }},
    {"slider", dJointCreateSlider, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetSliderAxis(j, at.a1.x, at.a1.y, at.a1.z);
         set_params(j, random, dJointSetSliderParam, 1);
     }},
    {"universal", dJointCreateUniversal, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetUniversalAnchor(j, at.p.x, at.p.y, at.p.z);
         dJointSetUniversalAxis1(j, at.a1.x, at.a1.y, at.a1.z);
         dJointSetUniversalAxis2(j, at.a2.x, at.a2.y, at.a2.z);
         set_params(j, random, dJointSetUniversalParam, 2);
     }},
    {"hinge2", dJointCreateHinge2, true,
     [](dJointID j, const Placement& at, Random& random) {
         const dVector3 a1 = {at.a1.x, at.a1.y, at.a1.z}, a2 = {at.a2.x, at.a2.y, at.a2.z};
         dJointSetHinge2Anchor(j, at.p.x, at.p.y, at.p.z);
         dJointSetHinge2Axes(j, a1, a2);
         set_params(j, random, dJointSetHinge2Param, 2);
         dJointSetHinge2Param(j, dParamSuspensionERP, random.range(0, 1));
         dJointSetHinge2Param(j, dParamSuspensionCFM, random.range(0, 1));
     }},
    {"fixed", dJointCreateFixed, false, [](dJointID j, const Placement&, Random&) { dJointSetFixed(j); }},
    {"amotor", dJointCreateAMotor, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetAMotorNumAxes(j, 3);
         dJointSetAMotorAxis(j, 0, 0, at.a1.x, at.a1.y, at.a1.z);
         dJointSetAMotorAxis(j, 1, 1, at.a2.x, at.a2.y, at.a2.z);
         dJointSetAMotorAxis(j, 2, 2, at.a3.x, at.a3.y, at.a3.z);
         for (int i = 0; i < 3; ++i) { dJointSetAMotorAngle(j, i, random.range(-1, 1)); }
         set_params(j, random, dJointSetAMotorParam, 3);
     }},
    {"euler", dJointCreateAMotor, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetAMotorMode(j, dAMotorEuler);
         dJointSetAMotorAxis(j, 0, 1, at.a1.x, at.a1.y, at.a1.z);
         dJointSetAMotorAxis(j, 2, 2, at.a3.x, at.a3.y, at.a3.z);
         set_params(j, random, dJointSetAMotorParam, 3);
     }},
    {"lmotor", dJointCreateLMotor, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetLMotorNumAxes(j, 3);
         dJointSetLMotorAxis(j, 0, 0, at.a1.x, at.a1.y, at.a1.z);
         dJointSetLMotorAxis(j, 1, 1, at.a2.x, at.a2.y, at.a2.z);
         dJointSetLMotorAxis(j, 2, 2, at.a3.x, at.a3.y, at.a3.z);
         set_params(j, random, dJointSetLMotorParam, 3);
     }},
    {"pr", dJointCreatePR, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetPRAnchor(j, at.p.x, at.p.y, at.p.z);
         dJointSetPRAxis1(j, at.a1.x, at.a1.y, at.a1.z);
         dJointSetPRAxis2(j, at.a2.x, at.a2.y, at.a2.z);
         set_params(j, random, dJointSetPRParam, 2);
     }},
    {"pu", dJointCreatePU, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetPUAnchor(j, at.p.x, at.p.y, at.p.z);
         dJointSetPUAxis1(j, at.a1.x, at.a1.y, at.a1.z);
         dJointSetPUAxis2(j, at.a2.x, at.a2.y, at.a2.z);
         dJointSetPUAxis3(j, at.a3.x, at.a3.y, at.a3.z);
         set_params(j, random, dJointSetPUParam, 3);
     }},
    {"piston", dJointCreatePiston, false,
     [](dJointID j, const Placement& at, Random& random) {
         dJointSetPistonAnchor(j, at.p.x, at.p.y, at.p.z);
         dJointSetPistonAxis(j, at.a1.x, at.a1.y, at.a1.z);
         set_params(j, random, dJointSetPistonParam, 2);
     }},
};

PARITY_CASE(dif_joints)
{
    for (const Kind& kind : kinds) {
        for (const Attach attach : all_attachments()) {
            const bool two = attach == Attach::kAB || attach == Attach::kBA;
            if (kind.two_bodies && !two) { continue; }
            for (int i = 0; i < 4; ++i) {
                out.open_block(std::string(kind.name) + "-" + attach_name(attach) + std::to_string(i));
                const Rig rig(rng, attach);
                const dJointID joint = kind.create(rig.world(), nullptr);
                rig.attach(joint);
                kind.set(joint, random_placement(rng), rng);
                put_dif(out, exported(rig.world(), "w"));
            }
        }
    }
}

}  // namespace
}  // namespace parity
