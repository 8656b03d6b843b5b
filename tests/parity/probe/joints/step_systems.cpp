// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep of larger systems: boxes on three or four contact points, random trees of mixed joints with
// contacts, a closed loop. Each is non-redundant, or has a CFM that makes its solution unique and
// well conditioned, so that an exact solver has one right answer.
#include "rig.h"

namespace parity {
namespace {

void put_points(Rig& rig, Random& random, int points, int mode, double mu)
{
    static const double corner[4][2] = {{-0.5, -0.4}, {0.5, -0.45}, {0.1, 0.5}, {-0.4, 0.45}};
    for (int i = 0; i < points; ++i) {
        dContact contact = dContact();
        contact.surface.mode = mode;
        contact.surface.mu = mu;
        contact.geom.normal[2] = 1;
        const dReal* p = dBodyGetPosition(rig.a());
        contact.geom.pos[0] = p[0] + corner[i][0];
        contact.geom.pos[1] = p[1] + corner[i][1];
        contact.geom.pos[2] = p[2] - 0.3;
        contact.geom.depth = random.range(0, 0.01);
        rig.attach(dJointCreateContact(rig.world(), nullptr, &contact));
    }
}

void step_and_put(Output& out, Rig& rig)
{
    out.put("step", {static_cast<double>(dWorldStep(rig.world(), rig.step_size()))});
    rig.put_bodies(out, "after");
}

void run_points(Output& out, Random& random, int points, int mode, const char* name)
{
    for (const Attach attach : all_attachments()) {
        for (int pose = 0; pose < 20; ++pose) {
            out.open_block(std::string(name) + "/" + attach_name(attach) + "/p" + std::to_string(pose));
            Rig rig(random, attach);
            dWorldSetCFM(rig.world(), 1e-4);
            const Vec3 pull = random.in_cube(4.0);
            dWorldSetGravity(rig.world(), pull.x, pull.y, attach == Attach::kBA ? 9.81 : -9.81);
            rig.push(random, 0.3);
            put_points(rig, random, points, mode, random.range(0.05, 1.0));
            step_and_put(out, rig);
        }
    }
}

PARITY_CASE(step_contacts_many)
{
    run_points(out, rng, 3, dContactApprox0, "three-approx0");
    run_points(out, rng, 3, dContactApprox1, "three-approx1");
    run_points(out, rng, 4, dContactApprox0, "four-approx0");
    run_points(out, rng, 4, dContactApprox1, "four-approx1");
    run_points(out, rng, 4, dContactApprox1_1, "four-approx1-1");
}

// A tree: body i hangs on an earlier body (or the world) by a random joint; some get a contact as well.
dJointID random_joint(dWorldID world, Random& random, dBodyID first, dBodyID second)
{
    const Vec3 p = random.in_cube(1.0), n = random.direction();
    const int kind = random.below(4);
    if (kind == 0) {
        const dJointID ball = dJointCreateBall(world, nullptr);
        dJointAttach(ball, first, second);
        dJointSetBallAnchor(ball, p.x, p.y, p.z);
        return ball;
    }
    if (kind == 1) {
        const dJointID hinge = dJointCreateHinge(world, nullptr);
        dJointAttach(hinge, first, second);
        dJointSetHingeAnchor(hinge, p.x, p.y, p.z);
        dJointSetHingeAxis(hinge, n.x, n.y, n.z);
        dJointSetHingeParam(hinge, dParamVel, random.range(-2, 2));
        dJointSetHingeParam(hinge, dParamFMax, random.range(0, 3));
        return hinge;
    }
    if (kind == 2) {
        const dJointID slider = dJointCreateSlider(world, nullptr);
        dJointAttach(slider, first, second);
        dJointSetSliderAxis(slider, n.x, n.y, n.z);
        dJointSetSliderParam(slider, dParamLoStop, random.range(-0.1, 0.05));
        dJointSetSliderParam(slider, dParamHiStop, random.range(0.05, 0.1));
        return slider;
    }
    const dJointID fixed = dJointCreateFixed(world, nullptr);
    dJointAttach(fixed, first, second);
    dJointSetFixed(fixed);
    return fixed;
}

void add_contact(dWorldID world, Random& random, dBodyID first, dBodyID second)
{
    dContact contact = dContact();
    const dReal* p = dBodyGetPosition(first);
    const Vec3 off = random.in_cube(0.5), n = random.direction();
    contact.surface.mode = random.unit() < 0.5 ? dContactApprox0 : dContactApprox1;
    contact.surface.mu = random.range(0, 1);
    contact.geom.pos[0] = p[0] + off.x;
    contact.geom.pos[1] = p[1] + off.y;
    contact.geom.pos[2] = p[2] + off.z;
    contact.geom.normal[0] = n.x;
    contact.geom.normal[1] = n.y;
    contact.geom.normal[2] = n.z;
    contact.geom.depth = random.range(0, 0.02);
    dJointAttach(dJointCreateContact(world, nullptr, &contact), first, second);
}

PARITY_CASE(step_trees)
{
    for (int trial = 0; trial < 60; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        dWorldSetGravity(world, 0, 0, -9.81);
        dWorldSetCFM(world, rng.range(1e-5, 1e-3));
        std::vector<dBodyID> bodies;
        for (int i = 0; i < 2 + trial % 7; ++i) {
            const dBodyID body = dBodyCreate(world);
            set_random_mass(body, rng);
            set_random_pose(body, rng, 1.0);
            const Vec3 v = rng.in_cube(1), w = rng.in_cube(1);
            dBodySetLinearVel(body, v.x, v.y, v.z);
            dBodySetAngularVel(body, w.x, w.y, w.z);
            const int partner = rng.below(i + 1) - 1;
            random_joint(world, rng, body, partner < 0 ? nullptr : bodies[static_cast<std::size_t>(partner)]);
            if (rng.unit() < 0.5) {
                add_contact(world, rng, body,
                            partner < 0 ? nullptr : bodies[static_cast<std::size_t>(partner)]);
            }
            bodies.push_back(body);
        }
        out.put("step", {static_cast<double>(dWorldStep(world, 0.01))});
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            out.put_body("after." + std::to_string(i), bodies[i]);
        }
        dWorldDestroy(world);
    }
}

}  // namespace
}  // namespace parity
