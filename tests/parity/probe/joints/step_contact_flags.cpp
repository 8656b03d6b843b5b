// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with a contact under each of the 2^14 combinations of surface flags, the four ways of
// attaching in turn: flags may not disturb one another. step_contact has more poses of fewer surfaces.
//
// Fields whose flag is not set hold numbers that would show. Rolling coefficients are positive
// (differences.tsv, D18).
#include "rig.h"

#include <cmath>

namespace parity {
namespace {

constexpr int kFlags[] = {dContactMu2,       dContactFDir1,    dContactBounce,  dContactSoftERP,
                          dContactSoftCFM,   dContactMotion1,  dContactMotion2, dContactMotionN,
                          dContactSlip1,     dContactSlip2,    dContactRolling, dContactApprox1_1,
                          dContactApprox1_2, dContactApprox1_N};
constexpr int kCount = 14;

dContact random_contact(Random& random, int mode)
{
    dContact c = dContact();
    const Vec3 p = random.in_cube(1.0), n = random.direction(), t = perpendicular_to(n, random);
    const dReal position[3] = {p.x, p.y, p.z}, normal[3] = {n.x, n.y, n.z}, first[3] = {t.x, t.y, t.z};
    for (int i = 0; i < 3; ++i) {
        c.geom.pos[i] = position[i];
        c.geom.normal[i] = normal[i];
        c.fdir1[i] = first[i];
    }
    c.geom.depth = random.range(0.0, 0.05);
    c.surface.mode = mode;
    c.surface.mu = random.range(0.05, 1.5);
    c.surface.mu2 = random.range(0.05, 1.5);
    c.surface.rho = random.range(0.01, 0.5);
    c.surface.rho2 = random.range(0.01, 0.5);
    c.surface.rhoN = random.range(0.01, 0.5);
    c.surface.bounce = random.range(0.1, 1.2);
    c.surface.bounce_vel = random.range(0, 0.3);
    c.surface.soft_erp = random.range(0, 1);
    c.surface.soft_cfm = random.range(1e-4, 1e-1);
    c.surface.motion1 = random.range(-2, 2);
    c.surface.motion2 = random.range(-2, 2);
    c.surface.motionN = random.range(-0.5, 0.5);
    c.surface.slip1 = random.range(1e-4, 1e-1);
    c.surface.slip2 = random.range(1e-4, 1e-1);
    return c;
}

using Step = int (*)(dWorldID, dReal);

void put_step(Output& out, Random& random, int mode, Step step, double friction)
{
    const Attach way = all_attachments()[static_cast<std::size_t>(random.below(4))];
    out.open_block(std::to_string(mode) + "/" + attach_name(way));
    Rig rig(random, way);
    rig.push(random, 2.0);
    dWorldSetQuickStepNumIterations(rig.world(), 2000);
    dContact contact = random_contact(random, mode);
    for (dReal* coefficient : {&contact.surface.mu, &contact.surface.mu2, &contact.surface.rho,
                               &contact.surface.rho2, &contact.surface.rhoN}) {
        *coefficient *= friction;
    }
    const dJointID joint = dJointCreateContact(rig.world(), nullptr, &contact);
    rig.attach(joint);
    dJointFeedback feedback = {};
    dJointSetFeedback(joint, &feedback);
    step(rig.world(), rig.step_size());
    out.put("lvel", dBodyGetLinearVel(rig.a()), 3);
    out.put("avel", dBodyGetAngularVel(rig.a()), 3);
    out.put("f1", feedback.f1, 3);
    out.put("t1", feedback.t1, 3);
    out.put("f2", feedback.f2, 3);
    out.put("t2", feedback.t2, 3);
}

int mode_of(int combination)
{
    int mode = 0;
    for (int i = 0; i < kCount; ++i) { mode |= combination >> i & 1 ? kFlags[i] : 0; }
    return mode;
}

PARITY_CASE(step_contact_flags)
{
    for (int combination = 0; combination < 1 << kCount; ++combination) {
        put_step(out, rng, mode_of(combination), &dWorldStep, 1);
    }
}

// QuickStep run to its end, under every 29th combination. With more friction some of these have no end: the
// limits follow the normal force, the normal force the friction, and both libraries go round in circles.
PARITY_CASE(quick_contact_flags)
{
    for (int combination = 0; combination < 1 << kCount; combination += 29) {
        put_step(out, rng, mode_of(combination), &dWorldQuickStep, 0.2);
    }
}

}  // namespace
}  // namespace parity
