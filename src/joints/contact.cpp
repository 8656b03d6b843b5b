// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contact: body 1 may only move along the normal n, away from body 2, and slides against friction.
//   normal     J v >= min(erp/h max(depth - layer, 0) + motionN, cap),  lambda >= 0
//   bounce     J v >= bounce approach + motionN  when  approach = motionN - J v(before) > bounce_vel
//   friction   J v  = motion along t1, t2,       |lambda| <= mu   or  mu times the normal force
//   rolling    the relative angular velocity about t1, t2, n vanishes within the same kind of bounds
//   J = [ d, r1 x d, -d, -(r2 x d) ] for d = n, t1, t2;   [ 0, d, 0, -d ] for rolling
// Friction bounds per direction (a pyramid), as ODE's interface defines its coefficients. A rolling
// coefficient of zero writes no row, where ODE writes an empty one that can stop its exact solver.
#include "ode/contact.h"
#include "joints/access.h"

namespace epode {

struct Contact : Joint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "contact_joint";
    Contact(const JointType& t, World& w, const dContact& c) : Joint(t, w), contact(c) {}

    dContact contact;

    bool has(int bits) const { return (contact.surface.mode & bits) != 0; }

    void emit(RowWriter& out) const;
    Row& contact_row(RowWriter& out, Vec3 d, RowKind kind) const;
    void write_normal(RowWriter& out, Vec3 n) const;
    void write_sliding(RowWriter& out, Vec3 t1, Vec3 t2) const;
    void write_rolling(RowWriter& out, Vec3 t1, Vec3 t2, Vec3 n) const;
    void tangents(Vec3 n, Vec3& t1, Vec3& t2) const;
    void bound(Row& row, Real coefficient, int approximation) const;
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(Contact);

void Contact::describe(DifWriter& out) const
{
    const dSurfaceParameters& s = contact.surface;
    const auto field = [&](int bit, const char* name, Real value) {
        if (has(bit)) out.real(name, value);
    };
    epode::describe(out, "pos", load(contact.geom.pos));
    epode::describe(out, "normal", load(contact.geom.normal));
    out.real("depth", contact.geom.depth);
    out.real("mu", s.mu);
    field(dContactMu2, "mu2", s.mu2);
    field(dContactRolling, "rho", s.rho);
    if (has(dContactRolling)) field(dContactAxisDep, "rho2", s.rho2);
    if (has(dContactRolling)) field(dContactAxisDep, "rhoN", s.rhoN);
    field(dContactBounce, "bounce", s.bounce);
    field(dContactBounce, "bounce_vel", s.bounce_vel);
    field(dContactSoftERP, "soft_ERP", s.soft_erp);
    field(dContactSoftCFM, "soft_CFM", s.soft_cfm);
    field(dContactMotion1, "motion1", s.motion1);
    field(dContactMotion2, "motion2", s.motion2);
    field(dContactMotionN, "motionN", s.motionN);
    field(dContactSlip1, "slip1", s.slip1);
    field(dContactSlip2, "slip2", s.slip2);
    // Approximations 1_1, 1_2 and 1_N as bits of a number.
    const int approximation = (s.mode & dContactApprox1) / dContactApprox1_1;
    if (approximation) out.integer("friction_approximation", approximation);
    if (has(dContactFDir1)) epode::describe(out, "fdir1", load(contact.fdir1));
}

Row& Contact::contact_row(RowWriter& out, Vec3 d, RowKind kind) const
{
    return out.row(point_jacobian(*this, d, out.arms().r1, out.arms().r2), 0, kind);
}

void Contact::emit(RowWriter& out) const
{
    const Vec3 p = load(contact.geom.pos);
    out.contact_at(p - body1()->position(), body2() ? p - body2()->position() : Vec3{});
    const Vec3 n = reverse ? -load(contact.geom.normal) : load(contact.geom.normal);
    write_normal(out, n);
    const dSurfaceParameters& s = contact.surface;
    if (!(s.mu > 0) && !has(dContactAxisDep | dContactRolling)) return;
    Vec3 t1, t2;
    tangents(n, t1, t2);
    write_sliding(out, t1, t2);
    if (has(dContactRolling)) write_rolling(out, t1, t2, n);
}

void Contact::write_normal(RowWriter& out, Vec3 n) const
{
    const dSurfaceParameters& s = contact.surface;
    Row& row = contact_row(out, n, RowKind::kNormal);
    const Real excess = contact.geom.depth - out.info().contact_layer;
    row.error = excess > 0 ? excess : 0;
    row.speed = has(dContactMotionN) ? s.motionN : 0;
    row.cap = out.info().contact_max_vel;
    if (has(dContactSoftERP)) row.erp = s.soft_erp;
    if (has(dContactSoftCFM)) row.cfm = s.soft_cfm;
    row.soft = has(dContactSoftERP | dContactSoftCFM);
    row.lo = 0;
    if (!has(dContactBounce) || !(s.bounce_vel >= 0)) return;
    const Vec3 p = load(contact.geom.pos);
    const Vec3 v = body1()->point_velocity(p) - (body2() ? body2()->point_velocity(p) : Vec3{});
    const Real approach = row.speed - dot(n, v);
    row.rebounds = approach > s.bounce_vel;
    row.rebound = s.bounce * approach + row.speed;
}

void Contact::tangents(Vec3 n, Vec3& t1, Vec3& t2) const
{
    plane_space(n, t1, t2);
    if (!has(dContactFDir1)) return;
    t1 = load(contact.fdir1);
    t2 = cross(n, t1);
}

void Contact::bound(Row& row, Real coefficient, int approximation) const
{
    row.hi = coefficient;
    row.lo = -coefficient;
    if (has(approximation)) row.parent = 0;
}

void Contact::write_sliding(RowWriter& out, Vec3 t1, Vec3 t2) const
{
    const dSurfaceParameters& s = contact.surface;
    const Real mu2 = has(dContactMu2) ? s.mu2 : s.mu;
    if (s.mu > 0) {
        Row& row = contact_row(out, t1, RowKind::kFriction);
        if (has(dContactMotion1)) row.speed = s.motion1;
        if (has(dContactSlip1)) row.cfm = s.slip1, row.soft = true;
        bound(row, s.mu, dContactApprox1_1);
    }
    if (mu2 > 0) {
        Row& row = contact_row(out, t2, RowKind::kFriction);
        if (has(dContactMotion2)) row.speed = s.motion2;
        if (has(dContactSlip2)) row.cfm = s.slip2, row.soft = true;
        bound(row, mu2, dContactApprox1_2);
    }
}

void Contact::write_rolling(RowWriter& out, Vec3 t1, Vec3 t2, Vec3 n) const
{
    const dSurfaceParameters& s = contact.surface;
    const Vec3 axis[3] = {t1, t2, n};
    const Real rho[3] = {s.rho, has(dContactAxisDep) ? s.rho2 : s.rho, has(dContactAxisDep) ? s.rhoN : s.rho};
    constexpr int kApproximation[3] = {dContactApprox1_1, dContactApprox1_2, dContactApprox1_N};
    for (int i = 0; i < 3; ++i)
        if (rho[i] > 0)
            bound(out.row(angular_jacobian(*this, axis[i]), 0, RowKind::kFriction), rho[i],
                  kApproximation[i]);
}

namespace {

// Members that few contacts have.
constexpr int kRare = dContactMu2 | dContactFDir1 | dContactMotion1 | dContactMotion2 | dContactMotionN |
                      dContactSlip1 | dContactSlip2 | dContactRolling;

bool usable_rare(const dContact& c)
{
    const dSurfaceParameters& s = c.surface;
    const auto fits = [&s](int bit, Real value) { return !(s.mode & bit) || usable_or_infinite(value); };
    const auto finite = [&s](int bit, Real value) { return !(s.mode & bit) || usable(value); };
    const bool both = (s.mode & dContactRolling) && (s.mode & dContactAxisDep);
    return fits(dContactMu2, s.mu2) && fits(dContactRolling, s.rho) &&
           (!both || (usable_or_infinite(s.rho2) && usable_or_infinite(s.rhoN))) &&
           finite(dContactMotion1, s.motion1) && finite(dContactMotion2, s.motion2) &&
           finite(dContactMotionN, s.motionN) && finite(dContactSlip1, s.slip1) &&
           finite(dContactSlip2, s.slip2) && (!(s.mode & dContactFDir1) || usable(c.fdir1, 3));
}

bool usable_softness(const dSurfaceParameters& s)
{
    const auto finite = [&s](int bit, Real value) { return !(s.mode & bit) || usable(value); };
    return finite(dContactBounce, s.bounce) && finite(dContactBounce, s.bounce_vel) &&
           finite(dContactSoftERP, s.soft_erp) && finite(dContactSoftCFM, s.soft_cfm);
}

// Place, normal and depth together: one comparison of the sum of squares instead of fourteen, since contacts
// are made by the thousand in every step. What is not finite makes the sum so.
bool usable_place(const dContactGeom& g)
{
    const Real n2 = length2(load(g.normal));
    return n2 > 0 && length2(load(g.pos)) + n2 + g.depth * g.depth <= kAbsurd * kAbsurd;
}

// Are all members that the mode names fit for use? Coefficients of friction may be infinite.
bool usable_contact(const dContact& c)
{
    const dSurfaceParameters& s = c.surface;
    return usable_or_infinite(s.mu) && usable_place(c.geom) &&
           (!(s.mode & (dContactBounce | dContactSoftERP | dContactSoftCFM)) || usable_softness(s)) &&
           (!(s.mode & kRare) || usable_rare(c));
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" dJointID dJointCreateContact(dWorldID w, dJointGroupID g, const dContact* contact)
{
    EPODE_USER(contact && usable_contact(*contact), nullptr);
    return create_joint_for<Contact>(__func__, w, g, *contact);
}
