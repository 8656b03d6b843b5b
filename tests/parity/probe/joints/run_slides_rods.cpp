// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Runs of 100 steps under gravity with PR, PU and piston joints and with rods: hanging, driven, into their
// stops; and joints attached again on the way, which take their geometry along.
#include "limit_states.h"

namespace parity {
namespace {

struct Hanging {
    dWorldID world = dWorldCreate();
    dBodyID upper = dBodyCreate(world), lower = dBodyCreate(world);

    Hanging()
    {
        dWorldSetGravity(world, 0, 0, -9.81);
        dMass mass;
        dMassSetBoxTotal(&mass, 2, 0.3, 0.4, 0.5);
        dBodySetMass(upper, &mass);
        dMassSetBoxTotal(&mass, 1, 0.2, 0.6, 0.3);
        dBodySetMass(lower, &mass);
        dBodySetPosition(upper, 0.4, 0, 0);
        dBodySetPosition(lower, 1.1, 0.2, -0.3);
    }
    ~Hanging() { dWorldDestroy(world); }
    Hanging(const Hanging&) = delete;
    Hanging& operator=(const Hanging&) = delete;

    // The upper body turns about y through the origin.
    void hang_upper() const
    {
        const dJointID hinge = dJointCreateHinge(world, nullptr);
        dJointAttach(hinge, upper, nullptr);
        dJointSetHingeAnchor(hinge, 0, 0, 0);
        dJointSetHingeAxis(hinge, 0, 1, 0);
    }
    void run(Output& out, double step_size = 0.005) const
    {
        for (int i = 0; i < 100; ++i) { dWorldStep(world, step_size); }
        out.put_body("upper", upper);
        out.put_body("lower", lower);
    }
};

PARITY_CASE(run_rod)
{
    for (const bool two : {false, true}) {
        out.open_block(two ? "two" : "world");
        Hanging h;
        if (two) { h.hang_upper(); }
        const dJointID rod = dJointCreateDBall(h.world, nullptr);
        dJointAttach(rod, h.lower, two ? h.upper : nullptr);
        dJointSetDBallAnchor1(rod, 1, 0.2, -0.2);
        dJointSetDBallAnchor2(rod, 0.5, -0.1, 0.1);
        h.run(out);
        put_vector(out, "anchor1", rod, &dJointGetDBallAnchor1);
        out.put("distance", {dJointGetDBallDistance(rod)});
    }
}

PARITY_CASE(run_bar)
{
    for (const bool two : {false, true}) {
        out.open_block(two ? "two" : "world");
        Hanging h;
        if (two) { h.hang_upper(); }
        const dJointID bar = dJointCreateDHinge(h.world, nullptr);
        dJointAttach(bar, h.lower, two ? h.upper : nullptr);
        dJointSetDHingeAxis(bar, 0, 1, 0);
        dJointSetDHingeAnchor1(bar, 1, 0.1, -0.2);
        dJointSetDHingeAnchor2(bar, 0.5, 0.1, 0.1);
        h.run(out);
        put_vector(out, "axis", bar, &dJointGetDHingeAxis);
        out.put("distance", {dJointGetDHingeDistance(bar)});
    }
}

PARITY_CASE(run_piston)
{
    for (const bool two : {false, true}) {
        out.open_block(two ? "two" : "world");
        Hanging h;
        if (two) { h.hang_upper(); }
        const dJointID piston = dJointCreatePiston(h.world, nullptr);
        dJointAttach(piston, h.lower, two ? h.upper : nullptr);
        dJointSetPistonAnchor(piston, 0.8, 0.1, -0.1);
        dJointSetPistonAxis(piston, 0.6, 0, -0.8);
        dJointSetPistonParam(piston, dParamHiStop, 0.2);
        dJointSetPistonParam(piston, dParamLoStop, -0.2);
        dJointSetPistonParam(piston, dParamBounce, 0.3);
        dJointSetPistonParam(piston, dParamVel2, 2);
        dJointSetPistonParam(piston, dParamFMax2, 3);
        h.run(out);
        out.put("slide", {dJointGetPistonPosition(piston), dJointGetPistonPositionRate(piston)});
        out.put("turn", {dJointGetPistonAngle(piston), dJointGetPistonAngleRate(piston)});
    }
}

// Both centres lie on the slide (D45), but for the error of a step, which is small.
PARITY_CASE(run_pr)
{
    for (const bool two : {false, true}) {
        out.open_block(two ? "two" : "world");
        Hanging h;
        if (two) { h.hang_upper(); }
        const dJointID pr = dJointCreatePR(h.world, nullptr);
        dJointAttach(pr, h.lower, two ? h.upper : nullptr);
        dBodySetPosition(h.lower, 0.7, 0, -0.4);
        dJointSetPRAnchor(pr, 0.4, 0, 0);
        dJointSetPRAxis1(pr, 0.6, 0, -0.8);
        dJointSetPRAxis2(pr, 0, 1, 0);
        dJointSetPRParam(pr, dParamHiStop, 0.2);
        dJointSetPRParam(pr, dParamLoStop, -0.2);
        dJointSetPRParam(pr, dParamLoStop2, -0.5);
        dJointSetPRParam(pr, dParamHiStop2, 0.5);
        h.run(out, 0.001);
        out.put("position", {dJointGetPRPosition(pr)});
        out.put("turn", {dJointGetPRAngle(pr), dJointGetPRAngleRate(pr)});
    }
}

// The slide is locked and the step is small: where anchors part, if only by the error of a step, the
// original's forces differ (D35).
PARITY_CASE(run_pu)
{
    Hanging h;
    const dJointID pu = dJointCreatePU(h.world, nullptr);
    dJointAttach(pu, h.lower, nullptr);
    dJointSetPUAnchor(pu, 0.8, 0.1, -0.1);
    dJointSetPUAxis1(pu, 0, 0.6, 0.8);
    dJointSetPUAxis2(pu, 1, 0, 0);
    dJointSetPUAxis3(pu, 0, 0.8, -0.6);
    dJointSetPUParam(pu, dParamLoStop3, 0);
    dJointSetPUParam(pu, dParamHiStop3, 0);
    dJointSetPUParam(pu, dParamVel2, 5);
    dJointSetPUParam(pu, dParamFMax2, 3);
    dBodySetAngularVel(h.lower, 0, 3, 4);  // about axis 1, through the anchor
    dBodySetLinearVel(h.lower, -1.0, 1.2, -0.9);
    h.run(out, 0.0002);
    out.put("angles", {dJointGetPUAngle1(pu), dJointGetPUAngle2(pu)});
}

// ---- attached again ----

using Put = void (*)(Output&, const std::string&, dJointID);

void put_pr(Output& out, const std::string& key, dJointID joint)
{
    put_vector(out, key + ".anchor", joint, &dJointGetPRAnchor);
    put_vector(out, key + ".axis1", joint, &dJointGetPRAxis1);
    put_vector(out, key + ".axis2", joint, &dJointGetPRAxis2);
    out.put(key + ".readings", {dJointGetPRPosition(joint), dJointGetPRAngle(joint)});
}

void put_pu(Output& out, const std::string& key, dJointID joint)
{
    put_vector(out, key + ".anchor", joint, &dJointGetPUAnchor);
    put_vector(out, key + ".axis1", joint, &dJointGetPUAxis1);
    put_vector(out, key + ".axis2", joint, &dJointGetPUAxis2);
    put_vector(out, key + ".axis3", joint, &dJointGetPUAxis3);
    out.put(key + ".readings",
            {dJointGetPUPosition(joint), dJointGetPUAngle1(joint), dJointGetPUAngle2(joint)});
}

void put_piston(Output& out, const std::string& key, dJointID joint)
{
    put_vector(out, key + ".anchor", joint, &dJointGetPistonAnchor);
    put_vector(out, key + ".anchor2", joint, &dJointGetPistonAnchor2);
    put_vector(out, key + ".axis", joint, &dJointGetPistonAxis);
    out.put(key + ".readings", {dJointGetPistonPosition(joint), dJointGetPistonAngle(joint)});
}

void put_rod(Output& out, const std::string& key, dJointID joint)
{
    put_vector(out, key + ".anchor1", joint, &dJointGetDBallAnchor1);
    put_vector(out, key + ".anchor2", joint, &dJointGetDBallAnchor2);
    out.put(key + ".distance", {dJointGetDBallDistance(joint)});
}

void put_bar(Output& out, const std::string& key, dJointID joint)
{
    put_vector(out, key + ".anchor1", joint, &dJointGetDHingeAnchor1);
    put_vector(out, key + ".anchor2", joint, &dJointGetDHingeAnchor2);
    put_vector(out, key + ".axis", joint, &dJointGetDHingeAxis);
    out.put(key + ".distance", {dJointGetDHingeDistance(joint)});
}

struct Kind {
    const char* name;
    dJointID (*create)(dWorldID, dJointGroupID);
    void (*set)(dJointID, const Vec3& p, const Vec3& n, const Vec3& m);
    Put put;
};

const Kind kKinds[] = {
    {"pr", &dJointCreatePR,
     [](dJointID j, const Vec3& p, const Vec3& n, const Vec3& m) {
         dJointSetPRAnchor(j, p.x, p.y, p.z);
         dJointSetPRAxis1(j, n.x, n.y, n.z);
         dJointSetPRAxis2(j, m.x, m.y, m.z);
     },
     &put_pr},
    {"pu", &dJointCreatePU,
     [](dJointID j, const Vec3& p, const Vec3& n, const Vec3& m) {
         dJointSetPUAnchor(j, p.x, p.y, p.z);
         dJointSetPUAxis1(j, n.x, n.y, n.z);
         dJointSetPUAxis2(j, m.x, m.y, m.z);
         dJointSetPUAxis3(j, 0.6, 0, 0.8);
     },
     &put_pu},
    {"piston", &dJointCreatePiston,
     [](dJointID j, const Vec3& p, const Vec3& n, const Vec3&) {
         dJointSetPistonAnchor(j, p.x, p.y, p.z);
         dJointSetPistonAxis(j, n.x, n.y, n.z);
     },
     &put_piston},
    {"dball", &dJointCreateDBall,
     [](dJointID j, const Vec3& p, const Vec3& n, const Vec3&) {
         dJointSetDBallAnchor1(j, p.x, p.y, p.z);
         dJointSetDBallAnchor2(j, n.x, n.y, n.z);
     },
     &put_rod},
    {"dhinge", &dJointCreateDHinge,
     [](dJointID j, const Vec3& p, const Vec3& n, const Vec3& m) {
         dJointSetDHingeAxis(j, m.x, m.y, m.z);
         dJointSetDHingeAnchor1(j, p.x, p.y, p.z);
         dJointSetDHingeAnchor2(j, n.x, n.y, n.z);
     },
     &put_bar},
};

// From each way of attaching to each other way, with fresh geometry and with old.
PARITY_CASE(step_attached_again)
{
    for (const Kind& kind : kKinds) {
        for (int from = 0; from < 4; ++from) {
            for (int to = 0; to < 4; ++to) {
                out.open_block(kind.name + std::string("/") + std::to_string(from) + std::to_string(to));
                const dWorldID world = dWorldCreate();
                const dBodyID a = dBodyCreate(world), b = dBodyCreate(world);
                set_random_pose(a, rng, 1.0);
                set_random_pose(b, rng, 1.0);
                const dJointID joint = kind.create(world, nullptr);
                const auto attach = [&](int way) {
                    dJointAttach(joint,
                                 way == 2   ? nullptr
                                 : way == 1 ? b
                                            : a,
                                 way == 3   ? nullptr
                                 : way == 1 ? a
                                 : way == 2 ? a
                                            : b);
                };
                attach(from);
                kind.put(out, "fresh", joint);
                const Vec3 p = rng.in_cube(1), n = rng.direction();
                kind.set(joint, p, n, perpendicular_to(n, rng));
                set_random_pose(a, rng, 1.0);
                set_random_pose(b, rng, 1.0);
                attach(to);
                kind.put(out, "again", joint);
                dWorldDestroy(world);
            }
        }
    }
}

}  // namespace
}  // namespace parity
