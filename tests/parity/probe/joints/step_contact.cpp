// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One dWorldStep with a contact joint: every surface flag alone and in combination, on one contact point, and
// boxes on several points, where the friction limits come from the frictionless solution.
//
// Coefficients of exactly 0 for rolling and negative ones are left out (differences.tsv, D18).
#include "rig.h"

#include <cmath>

namespace parity {
namespace {

using Edit = void (*)(dContact&, Random&);

struct Surface {
    const char* name;
    Edit edit;
};

void base_contact(dContact& contact, Random& random)
{
    contact = dContact();
    const Vec3 p = random.in_cube(1.0), n = random.direction();
    contact.geom.pos[0] = p.x;
    contact.geom.pos[1] = p.y;
    contact.geom.pos[2] = p.z;
    contact.geom.normal[0] = n.x;
    contact.geom.normal[1] = n.y;
    contact.geom.normal[2] = n.z;
    contact.geom.depth = random.range(0.0, 0.05);
    contact.surface.mu = random.range(0.1, 1.5);
}

void add(dContact& contact, int flags) { contact.surface.mode |= flags; }

void frictionless(dContact& c, Random&) { c.surface.mu = 0; }
void plain(dContact&, Random&) {}
void strong(dContact& c, Random&) { c.surface.mu = 1e4; }
void infinite(dContact& c, Random&) { c.surface.mu = dInfinity; }
void mu2(dContact& c, Random& r)
{
    add(c, dContactMu2);
    c.surface.mu2 = r.range(0.1, 20);
}
void mu2_zero(dContact& c, Random&)
{
    add(c, dContactMu2);
    c.surface.mu2 = 0;
}
void mu_zero_mu2(dContact& c, Random& r)
{
    mu2(c, r);
    c.surface.mu = 0;
}
void mu_negative(dContact& c, Random&) { c.surface.mu = -1; }

void fdir(dContact& c, Random& r)
{
    add(c, dContactFDir1);
    const Vec3 d = r.direction();
    const dReal* n = c.geom.normal;
    const double along = d.x * n[0] + d.y * n[1] + d.z * n[2];
    const double x = d.x - along * n[0], y = d.y - along * n[1], z = d.z - along * n[2];
    const double length = std::sqrt(x * x + y * y + z * z);
    c.fdir1[0] = x / length;
    c.fdir1[1] = y / length;
    c.fdir1[2] = z / length;
}

void fdir_raw(dContact& c, Random& r)
{  // neither unit nor tangential: the caller's vector is used as given
    fdir(c, r);
    c.fdir1[0] *= 1.5;
    c.fdir1[1] += 0.2;
}

void bounce(dContact& c, Random& r)
{
    add(c, dContactBounce);
    c.surface.bounce = r.range(0, 1.2);
    c.surface.bounce_vel = 0.1;
}

void bounce_slow(dContact& c, Random& r)
{
    bounce(c, r);
    c.surface.bounce_vel = 100;
}
void bounce_off(dContact& c, Random& r)
{
    bounce(c, r);
    c.surface.bounce_vel = -1;
}
void soft_erp(dContact& c, Random& r)
{
    add(c, dContactSoftERP);
    c.surface.soft_erp = r.range(0, 1);
}
void soft_cfm(dContact& c, Random& r)
{
    add(c, dContactSoftCFM);
    c.surface.soft_cfm = r.range(1e-4, 1e-1);
}
void motion1(dContact& c, Random& r)
{
    add(c, dContactMotion1);
    c.surface.motion1 = r.range(-2, 2);
}
void motion2(dContact& c, Random& r)
{
    add(c, dContactMotion2);
    c.surface.motion2 = r.range(-2, 2);
}
void motion_n(dContact& c, Random& r)
{
    add(c, dContactMotionN);
    c.surface.motionN = r.range(-2, 2);
}
void slip1(dContact& c, Random& r)
{
    add(c, dContactSlip1);
    c.surface.slip1 = r.range(1e-4, 1e-1);
}
void slip2(dContact& c, Random& r)
{
    add(c, dContactSlip2);
    c.surface.slip2 = r.range(1e-4, 1e-1);
}
void approx1(dContact& c, Random&) { add(c, dContactApprox1); }
void approx1_1(dContact& c, Random&) { add(c, dContactApprox1_1); }
void approx1_2(dContact& c, Random&) { add(c, dContactApprox1_2); }
void approx1_infinite(dContact& c, Random&)
{
    add(c, dContactApprox1);
    c.surface.mu = dInfinity;
}
void rolling(dContact& c, Random& r)
{
    add(c, dContactRolling);
    c.surface.rho = r.range(0.01, 0.5);
}
void rolling_axes(dContact& c, Random& r)
{
    add(c, dContactRolling | dContactMu2);
    c.surface.mu2 = r.range(0.1, 2);
    c.surface.rho = r.range(0.01, 0.5);
    c.surface.rho2 = r.range(0.01, 0.5);
    c.surface.rhoN = r.range(0.01, 0.5);
}
void rolling_approx(dContact& c, Random& r)
{
    rolling_axes(c, r);
    approx1(c, r);
}
void rolling_approx_n(dContact& c, Random& r)
{
    rolling_axes(c, r);
    add(c, dContactApprox1_N);
}
void bounce_motion(dContact& c, Random& r)
{
    bounce(c, r);
    motion_n(c, r);
}
void soft_both(dContact& c, Random& r)
{
    soft_erp(c, r);
    soft_cfm(c, r);
}
void motions(dContact& c, Random& r)
{
    motion1(c, r);
    motion2(c, r);
    motion_n(c, r);
    strong(c, r);
}
void slips(dContact& c, Random& r)
{
    slip1(c, r);
    slip2(c, r);
    strong(c, r);
}
void fdir_motion(dContact& c, Random& r)
{
    fdir(c, r);
    motion1(c, r);
    slip2(c, r);
    approx1(c, r);
}
void everything(dContact& c, Random& r)
{
    rolling_axes(c, r);
    fdir(c, r);
    bounce(c, r);
    soft_both(c, r);
    motion1(c, r);
    motion2(c, r);
    motion_n(c, r);
    slip1(c, r);
    slip2(c, r);
    approx1(c, r);
}

const Surface kSurfaces[] = {
    {"frictionless", frictionless},
    {"mu", plain},
    {"mu-strong", strong},
    {"mu-infinite", infinite},
    {"mu-negative", mu_negative},
    {"mu2", mu2},
    {"mu2-zero", mu2_zero},
    {"mu-zero-mu2", mu_zero_mu2},
    {"fdir1", fdir},
    {"fdir1-raw", fdir_raw},
    {"bounce", bounce},
    {"bounce-below", bounce_slow},
    {"bounce-off", bounce_off},
    {"soft-erp", soft_erp},
    {"soft-cfm", soft_cfm},
    {"soft-both", soft_both},
    {"motion1", motion1},
    {"motion2", motion2},
    {"motionN", motion_n},
    {"motions", motions},
    {"slip1", slip1},
    {"slip2", slip2},
    {"slips", slips},
    {"approx1", approx1},
    {"approx1-1", approx1_1},
    {"approx1-2", approx1_2},
    {"approx1-infinite", approx1_infinite},
    {"rolling", rolling},
    {"rolling-axes", rolling_axes},
    {"rolling-approx1", rolling_approx},
    {"rolling-approx1N", rolling_approx_n},
    {"bounce-motion", bounce_motion},
    {"fdir1-motion-slip", fdir_motion},
    {"everything", everything},
};

void no_setting(dWorldID, Random&) {}
void surface_layer(dWorldID world, Random& r) { dWorldSetContactSurfaceLayer(world, r.range(0, 0.05)); }
void correcting_velocity(dWorldID world, Random& r)
{
    dWorldSetContactMaxCorrectingVel(world, r.range(0.01, 1));
}

void run_surfaces(Output& out, Random& random, void (*world_setting)(dWorldID, Random&), int poses)
{
    for (const Surface& surface : kSurfaces) {
        JointBench bench;
        bench.poses = poses;
        bench.create = [&](const Rig& rig, Random& r) {
            dContact contact;
            base_contact(contact, r);
            surface.edit(contact, r);
            world_setting(rig.world(), r);
            const dJointID joint = dJointCreateContact(rig.world(), nullptr, &contact);
            rig.attach(joint);
            return joint;
        };
        bench.put_getters = [](Output& o, const std::string& when, dJointID joint) {
            o.put(when + ".type", {static_cast<double>(dJointGetType(joint))});
        };
        bench.variants.push_back({surface.name, [](dJointID, Random&) {}});
        run_bench(out, random, bench);
    }
}

PARITY_CASE(step_contact) { run_surfaces(out, rng, no_setting, 20); }

PARITY_CASE(step_contact_surface_layer) { run_surfaces(out, rng, surface_layer, 5); }

PARITY_CASE(step_contact_correcting_velocity) { run_surfaces(out, rng, correcting_velocity, 5); }

}  // namespace
}  // namespace parity
