// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What our worlds do as ODE does only if they have its behaviour (EPODE_BEHAVIOUR=0.16): dWorldQuickStep far
// from convergence, whose result is its order of rows; bodies that fall asleep one by one; the rest of a
// finite rotation about an axis. By default these differ, which differences.tsv names; the test parity_016
// wants them equal.
#include "joints/every_joint.h"

#include <vector>

namespace parity {
namespace {

// PR, PU, piston and transmission have forces of their own in the original (differences.tsv).
bool is_comparable(const JointKind& kind)
{
    const std::string name = kind.name;
    return name != "pr" && name != "pu" && name != "piston" && name != "transmission";
}

PARITY_CASE(behaviour_quick_joints)
{
    for (const JointKind& kind : every_joint()) {
        if (!is_comparable(kind)) { continue; }
        for (const Attach attach : attachments_of(kind)) {
            for (int pose = 0; pose < 4; ++pose) {
                out.open_block(std::string(kind.name) + "/" + attach_name(attach) + "/p" +
                               std::to_string(pose));
                Rig rig(rng, attach);
                const dJointID joint = kind.create(rig.world(), nullptr);
                rig.attach(joint);
                place_at_random(kind, joint, rng);
                rig.disturb(rng, 0.02, 0.1);
                rig.push(rng, 1.0);
                dRandSetSeed(static_cast<unsigned long>(pose));
                for (int i = 0; i < 3; ++i) { dWorldQuickStep(rig.world(), rig.step_size()); }
                rig.put_bodies(out, "after");
                out.put("seed", {static_cast<double>(dRandGetSeed())});
            }
        }
    }
}

// A chain that falls: many rows, of which twenty sweeps solve little.
PARITY_CASE(behaviour_quick_chain)
{
    for (int seed = 0; seed < 3; ++seed) {
        out.open_block("seed" + std::to_string(seed));
        const dWorldID world = dWorldCreate();
        dWorldSetGravity(world, 0, 0, -9.81);
        std::vector<dBodyID> links;
        for (int i = 0; i < 12; ++i) {
            const dBodyID link = dBodyCreate(world);
            dBodySetPosition(link, 0.5 * i + 0.25, 0, 0);
            dMass mass;
            dMassSetBoxTotal(&mass, 1 + i % 3, 0.5, 0.2, 0.1);
            dBodySetMass(link, &mass);
            const dJointID joint =
                i % 2 ? dJointCreateBall(world, nullptr) : dJointCreateHinge(world, nullptr);
            dJointAttach(joint, link, links.empty() ? nullptr : links.back());
            if (i % 2) {
                dJointSetBallAnchor(joint, 0.5 * i, 0, 0);
            } else {
                dJointSetHingeAnchor(joint, 0.5 * i, 0, 0);
                dJointSetHingeAxis(joint, 0, 1, 0);
            }
            links.push_back(link);
        }
        dRandSetSeed(static_cast<unsigned long>(seed));
        for (int i = 0; i < 20; ++i) { dWorldQuickStep(world, 0.01); }
        for (std::size_t i = 0; i < links.size(); ++i) { out.put_body("b" + std::to_string(i), links[i]); }
        dWorldDestroy(world);
    }
}

struct Pile {
    dWorldID world = dWorldCreate();
    dSpaceID space = dSimpleSpaceCreate(nullptr);
    dJointGroupID contacts = dJointGroupCreate(0);
    std::vector<dBodyID> balls;

    Pile()
    {
        dWorldSetGravity(world, 0, 0, -9.81);
        dCreatePlane(space, 0, 0, 1, 0);
    }
    ~Pile()
    {
        dJointGroupDestroy(contacts);
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }
    Pile(const Pile&) = delete;
    Pile& operator=(const Pile&) = delete;

    void ball(double x, double y, double z)
    {
        const dBodyID body = dBodyCreate(world);
        dMass mass;
        dMassSetSphereTotal(&mass, 1, 0.5);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x, y, z);
        dGeomSetBody(dCreateSphere(space, 0.5), body);
        balls.push_back(body);
    }
    static void near(void* data, dGeomID a, dGeomID b)
    {
        Pile& pile = *static_cast<Pile*>(data);
        dContact found[1] = {};
        if (dCollide(a, b, 1, &found[0].geom, sizeof(dContact)) == 0) { return; }
        found[0].surface.mode = dContactApprox1;
        found[0].surface.mu = 0.5;
        dJointAttach(dJointCreateContact(pile.world, pile.contacts, &found[0]), dGeomGetBody(a),
                     dGeomGetBody(b));
    }
    // The pairs in one order in both libraries (differences.tsv, G1 of docs/compat.md).
    void collide()
    {
        const int count = dSpaceGetNumGeoms(space);
        std::vector<dGeomID> geoms;
        for (const dBodyID ball : balls) { geoms.push_back(dBodyGetFirstGeom(ball)); }
        for (int i = 0; i < count; ++i) {
            const dGeomID geom = dSpaceGetGeom(space, i);
            if (dGeomGetClass(geom) == dPlaneClass) { geoms.push_back(geom); }
        }
        for (std::size_t i = 0; i < geoms.size(); ++i) {
            for (std::size_t k = i + 1; k < geoms.size(); ++k) { near(this, geoms[i], geoms[k]); }
        }
    }
    void step(int count)
    {
        for (int i = 0; i < count; ++i) {
            collide();
            dWorldQuickStep(world, 0.01);
            dJointGroupEmpty(contacts);
        }
    }
};

PARITY_CASE(behaviour_quick_balls)
{
    for (int trial = 0; trial < 4; ++trial) {
        out.open_block("t" + std::to_string(trial));
        Pile pile;
        for (int i = 0; i < 18; ++i) {
            pile.ball(1.01 * (i % 3) + rng.range(-0.1, 0.1), 1.01 * (i / 3 % 3) + rng.range(-0.1, 0.1),
                      0.55 + 0.95 * (i / 9));
        }
        dRandSetSeed(static_cast<unsigned long>(trial));
        pile.step(25);
        for (std::size_t i = 0; i < pile.balls.size(); ++i) {
            out.put_body("b" + std::to_string(i), pile.balls[i]);
        }
    }
}

// Of three joined bodies some are idle and some are not; the idle ones lose their momentum and wake again.
PARITY_CASE(behaviour_sleep_one_by_one)
{
    for (int trial = 0; trial < 40; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        dWorldSetAutoDisableFlag(world, 1);
        dWorldSetAutoDisableSteps(world, 3 + trial % 5);
        dWorldSetAutoDisableAverageSamplesCount(world, 1 + static_cast<unsigned>(trial % 3));
        dBodyID bodies[3];
        for (int i = 0; i < 3; ++i) {
            bodies[i] = dBodyCreate(world);
            dBodySetPosition(bodies[i], i, 0, 0);
            dBodySetLinearVel(bodies[i], 0, rng.unit() < 0.5 ? 0.0 : rng.range(0.001, 0.03), 0);
            if (i == 0) { continue; }
            const dJointID joint = dJointCreateBall(world, nullptr);
            dJointAttach(joint, bodies[i - 1], bodies[i]);
            dJointSetBallAnchor(joint, i - 0.5, 0, 0);
        }
        std::string sequence = "=";
        for (int step = 0; step < 40; ++step) {
            dWorldStep(world, 0.01);
            for (const dBodyID body : bodies) { sequence += dBodyIsEnabled(body) ? '1' : '0'; }
        }
        out.put_text("enabled", sequence);
        for (int i = 0; i < 3; ++i) { out.put_body("b" + std::to_string(i), bodies[i]); }
        dWorldDestroy(world);
    }
}

PARITY_CASE(behaviour_finite_axis)
{
    for (int trial = 0; trial < 10; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        const dBodyID body = dBodyCreate(world);
        dBodySetFiniteRotationMode(body, 1);
        dBodySetFiniteRotationAxis(body, 0, 0.6, 0.8);
        dBodySetAngularVel(body, rng.range(-3, 3), rng.range(-3, 3), rng.range(-3, 3));
        for (int i = 0; i < 50; ++i) { dWorldStep(world, 0.01); }
        out.put_body("after", body);
        dWorldDestroy(world);
    }
}

}  // namespace
}  // namespace parity
