// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions that are second names or halves of others: capped cylinders, identities, the two halves of
// dJointSetHinge2Axes, the second offset of a universal, world settings one by one, orthogonalisation.
#include "joints/every_joint.h"

#include <cmath>

namespace parity {
namespace {

PARITY_CASE(mass_capped_cylinder)
{
    for (int i = 0; i < 12; ++i) {
        dMass m;
        const std::string n = std::to_string(i);
        dMassSetCappedCylinder(&m, rng.range(0.1, 5), 1 + i % 3, rng.range(0.1, 2), rng.range(0.1, 2));
        out.put("density" + n, {m.mass, m.c[0], m.c[1], m.c[2]});
        out.put_matrix3("density-inertia" + n, m.I);
        dMassSetCappedCylinderTotal(&m, rng.range(0.1, 5), 1 + i % 3, rng.range(0.1, 2), rng.range(0.1, 2));
        out.put("total" + n, {m.mass, m.c[0], m.c[1], m.c[2]});
        out.put_matrix3("total-inertia" + n, m.I);
    }
}

PARITY_CASE(math_identities)
{
    dMatrix3 R;
    dQuaternion q;
    for (dReal& value : R) { value = 7; }
    for (dReal& value : q) { value = 7; }
    dRSetIdentity(R);
    dQSetIdentity(q);
    out.put("R", R, 12);
    out.put("q", q, 4);
    // Zero and parallel axes: the identity, or a message and nothing.
    dRFromAxisAndAngle(R, 0, 0, 0, 1);
    out.put("zero-axis", R, 12);
    dQFromAxisAndAngle(q, 0, 0, 0, 1);
    out.put("zero-axis-q", q, 4);
    for (dReal& value : R) { value = 7; }
    dRFrom2Axes(R, 1, 2, 3, 2, 4, 6);
    out.put("parallel", R, 12);
    dRFrom2Axes(R, 0, 0, 0, 1, 0, 0);
    out.put("zero", R, 12);
    dRFromEulerAngles(R, 0.3, 1.5707963267948966, 0.4);
    out.put("locked-euler", R, 12);
    const double edge = std::sqrt(0.5);
    for (const double lean : {-1e-9, 0.0, 1e-9}) {
        const double z = edge + lean, x = std::sqrt(1 - z * z);
        const dVector3 n = {x, 0, z, 0};
        dVector3 p = {0, 0, 0, 0}, k = {0, 0, 0, 0};
        if (lean == 0.0) { continue; }  // at the edge itself rounding decides
        dPlaneSpace(n, p, k);
        out.put("plane-p", p, 3);
        out.put("plane-q", k, 3);
    }
}

// Rows that are perpendicular already, or that cannot be made so. (Between, the original leaves row 1 as it
// was: differences.tsv, D1.)
PARITY_CASE(math_orthogonalize)
{
    for (int i = 0; i < 20; ++i) {
        out.open_block("t" + std::to_string(i));
        const Quat r = rng.rotation(3);
        const Vec3 a = rotate(r, {1, 0, 0}), b = rotate(r, {0, 1, 0});
        const double s = rng.range(0.3, 3);
        dMatrix3 R = {s * a.x, s * a.y, s * a.z, 0, b.x, b.y, b.z, 0, rng.unit(), rng.unit(), rng.unit(), 0};
        const int ok = dOrthogonalizeR(R);
        out.put("ok", {static_cast<double>(ok)});
        out.put("row0", R, 3);
        out.put("row2", R + 8, 3);
    }
    out.open_block("degenerate");
    dMatrix3 zero = {0}, parallel = {1, 2, 3, 0, 2, 4, 6, 0, 0, 0, 1, 0};
    out.put("zero.ok", {static_cast<double>(dOrthogonalizeR(zero))});
    out.put("parallel.ok", {static_cast<double>(dOrthogonalizeR(parallel))});
}

PARITY_CASE(math_normalize_unsafe)
{
    for (int i = 0; i < 40; ++i) {
        const double scale = std::pow(10.0, rng.range(-150, 150));
        const Vec3 d = rng.direction();
        dVector3 v = {d.x * scale, d.y * scale, d.z * scale, 3};
        dVector4 q = {rng.range(-9, 9), rng.range(-9, 9), rng.range(-9, 9), rng.range(-9, 9)};
        dNormalize3(v);
        dNormalize4(q);
        out.put("three" + std::to_string(i), v, 3);
        out.put("four" + std::to_string(i), q, 4);
    }
}

PARITY_CASE(step_hinge2_single_axes)
{
    for (int trial = 0; trial < 20; ++trial) {
        out.open_block("t" + std::to_string(trial));
        Rig rig(rng, trial % 2 ? Attach::kAB : Attach::kBA);
        const dJointID joint = dJointCreateHinge2(rig.world(), nullptr);
        rig.attach(joint);
        const JointPlace at = random_place(rng);
        dJointSetHinge2Anchor(joint, at.p.x, at.p.y, at.p.z);
        dJointSetHinge2Axis1(joint, at.n.x, at.n.y, at.n.z);
        dJointSetHinge2Axis2(joint, at.m.x, at.m.y, at.m.z);
        rig.disturb(rng, 0.1, 0.4);
        dVector3 axis1 = {0, 0, 0, 0}, axis2 = {0, 0, 0, 0};
        dJointGetHinge2Axis1(joint, axis1);
        dJointGetHinge2Axis2(joint, axis2);
        out.put("axis1", axis1, 3);
        out.put("axis2", axis2, 3);
        out.put("angles", {dJointGetHinge2Angle1(joint), dJointGetHinge2Angle2(joint)});
        rig.push(rng, 2.0);
        dWorldStep(rig.world(), rig.step_size());
        rig.put_bodies(out, "after");
    }
}

// Both offsets, one after the other, between two bodies (differences.tsv, D13).
PARITY_CASE(step_universal_both_offsets)
{
    for (int trial = 0; trial < 20; ++trial) {
        out.open_block("t" + std::to_string(trial));
        Rig rig(rng, Attach::kAB);
        const dJointID joint = dJointCreateUniversal(rig.world(), nullptr);
        rig.attach(joint);
        const JointPlace at = random_place(rng);
        dJointSetUniversalAnchor(joint, at.p.x, at.p.y, at.p.z);
        dJointSetUniversalAxis1(joint, at.n.x, at.n.y, at.n.z);
        dJointSetUniversalAxis2(joint, at.m.x, at.m.y, at.m.z);
        dJointSetUniversalAxis2Offset(joint, at.m.x, at.m.y, at.m.z, rng.range(-2, 2), rng.range(-2, 2));
        out.put("angles", {dJointGetUniversalAngle1(joint), dJointGetUniversalAngle2(joint)});
        rig.disturb(rng, 0.1, 0.4);
        out.put("turned", {dJointGetUniversalAngle1(joint), dJointGetUniversalAngle2(joint)});
        rig.push(rng, 2.0);
        dWorldStep(rig.world(), rig.step_size());
        rig.put_bodies(out, "after");
    }
}

PARITY_CASE(world_single_settings)
{
    const dWorldID world = dWorldCreate();
    int mark = 0;
    for (int i = 0; i < 20; ++i) {
        out.open_block("t" + std::to_string(i));
        dWorldSetLinearDamping(world, i % 4 == 0 ? 0 : rng.range(0, 1));
        dWorldSetAngularDamping(world, i % 5 == 0 ? 0 : rng.range(0, 1));
        dWorldSetStepIslandsProcessingMaxThreadCount(world, static_cast<unsigned>(i % 4));
        dWorldSetData(world, i % 2 ? &mark : nullptr);
        out.put("read", {dWorldGetLinearDamping(world), dWorldGetAngularDamping(world),
                         static_cast<double>(dWorldGetStepIslandsProcessingMaxThreadCount(world)),
                         dWorldGetData(world) == &mark ? 1.0 : 0.0});
        const dBodyID body = dBodyCreate(world);
        dBodySetLinearVel(body, 1, 2, 3);
        dBodySetAngularVel(body, 3, 2, 1);
        out.put("copied", {dBodyGetLinearDamping(body), dBodyGetAngularDamping(body)});
        for (int k = 0; k < 3; ++k) { dWorldStep(world, 0.01); }
        out.put_body("after", body);
        dBodyDestroy(body);
    }
    dWorldDestroy(world);
}

// The box of a geom is computed again when it has moved. A client that writes into the position it was given says
// so.
PARITY_CASE(geom_marked_moved)
{
    const dSpaceID space = dHashSpaceCreate(nullptr);
    const dGeomID g = dCreateBox(space, 1, 2, 3);
    dReal box[6] = {0};
    dGeomGetAABB(g, box);
    out.put("before", box, 6);
    const_cast<dReal*>(dGeomGetPosition(g))[0] = 5;
    dGeomGetAABB(g, box);
    out.put("unsaid", box, 6);
    dGeomMoved(g);
    dGeomGetAABB(g, box);
    out.put("said", box, 6);
    dGeomGetAABB(reinterpret_cast<dGeomID>(space), box);
    out.put("space", box, 6);
    dSpaceDestroy(space);
}

}  // namespace
}  // namespace parity
