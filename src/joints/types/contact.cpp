// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contact: body 1 may only move along the normal n, away from body 2, and slides against friction.
//   normal     J v >= min(erp/h max(depth - layer, 0) + motionN - max(touch - depth, 0)/h, cap),  lambda >= 0
//   bounce     J v >= bounce approach + motionN  when  approach = motionN - J v(before) > bounce_vel
//   friction   J v  = motion along t1, t2,       |lambda| <= mu   or  mu times the normal force
//   rolling    the relative angular velocity about t1, t2, n vanishes within the same kind of bounds
//   J = [ d, r1 x d, -d, -(r2 x d) ] for d = n, t1, t2;   [ 0, d, 0, -d ] for rolling
// A contact may close to the depth `touch`, which is rounding, and for sweeps what they leave over: where what
// rests is held at a depth of 0 exactly, collision finds one corner in some steps and not in others, and a box
// near its angle of friction falls and slides by a millimetre in every such step.
// Friction bounds per direction (a pyramid), as ODE's interface defines its coefficients. A rolling
// coefficient of zero writes no row, where ODE writes an empty one that can stop its exact solver.
#include "ode/contact.h"

#include <algorithm>
#include <limits>

#include "base/prefetch.h"
#include "joints/access.h"
#include "joints/joint_manifolds.h"
#include "rows/policy.h"

namespace epode {

// Most contacts have place, normal, depth, mode and mu and nothing else, which is one line of the cache
// behind those of the Joint: they are no larger than that, and of a pool of their own, so that they lie side
// by side. The others are SpecialContacts.
struct Contact : Joint {
    static constexpr int kMaxRows = 6;
    static constexpr const char* kDifName = "contact_joint";
    Contact(const JointType& t, World& w, const dContact& c)
        : Joint(t, w),
          pos(load(c.geom.pos)),
          normal(load(c.geom.normal)),
          depth(c.geom.depth),
          mu(c.surface.mu)
    {
        mode = std::uint16_t(c.surface.mode);
        plain = true;
    }

    alignas(kCacheLine) Vec3 pos;
    Vec3 normal;
    Real depth, mu;

    bool has(int bits) const { return (mode & bits) != 0; }
    bool special() const { return is_special(mode); }
    // Is any member of the surface named but mu and the kind of friction?
    static bool is_special(int mode) { return (std::uint16_t(mode) & ~dContactApprox1) != 0; }
    const dSurfaceParameters& surface() const;  // of a special contact
    const Real* fdir1() const;                  // likewise
    void destroy();
    // Below this a contact may close: rounding, and what sweeps leave over where it is one of several.
    Real touching_depth(const StepInfo& info, bool several) const
    {
        return rounding() + (several ? info.touching_depth : std::min(info.touching_depth, Real(0)));
    }
    // Of the depth. In floats a floor knows nothing of how far away along it a body lies: 60 m were 0.06 mm, which bodies sank
    // by and closed again in every substep, with a fifth of friction too much. (Doubles lose nothing that shows.)
    Real rounding() const
    {
        constexpr Real kDigits = 8 * std::numeric_limits<Real>::epsilon();
        const auto largest = [](Vec3 a) { return std::max({a.x, a.y, a.z}); };
        if (!kSingle) return kDigits * largest(abs(pos));
        const Vec3 n = abs(normal), x = abs(pos), arm = abs(pos - body1()->position());
        return kDigits * std::max(dot(n, x), largest(arm));
    }
    Vec3 outward() const { return reverse ? -normal : normal; }  // into body 1
    Real mu2() const { return has(dContactMu2) ? surface().mu2 : mu; }
    bool sliding_at_all() const { return mu > 0 || has(dContactAxisDep | dContactRolling); }

    void emit(RowWriter& out) const;
    Row& contact_row(RowWriter& out, Vec3 d, RowKind kind) const;
    void aim_normal(Row& row, const StepInfo& info, Vec3 n, Real touching_depth) const;
    void aim_rebound(Row& row, Vec3 n) const;
    void write_sliding(RowWriter& out, Vec3 t1, Vec3 t2) const;
    void write_rolling(RowWriter& out, Vec3 t1, Vec3 t2, Vec3 n) const;
    void tangents(Vec3 n, Vec3& t1, Vec3& t2) const;
    void bound(Row& row, Real coefficient, int approximation) const;
    void shift(Vec3 by) { pos += by; }
    void structure(StructureStream& stream);
    static Joint* make(World& world, StructureStream& stream);
    void describe(DifWriter& out) const;
};

JOINT_DEFINE(Contact);

struct SpecialContact : Contact {
    SpecialContact(const JointType& t, World& w, const dContact& c)
        : Contact(t, w, c), special_surface(c.surface)
    {
        std::copy_n(c.fdir1, 3, special_fdir1);
        plain = fits_manifold();
    }

    // But mode and mu; members that the mode does not name may be anything.
    dSurfaceParameters special_surface;
    Real special_fdir1[3];

    bool fits_manifold() const;
};

template <>
struct JointTypeOf<SpecialContact> : JointTypeOf<Contact> {};

inline const dSurfaceParameters& Contact::surface() const
{
    return static_cast<const SpecialContact*>(this)->special_surface;
}

inline const Real* Contact::fdir1() const { return static_cast<const SpecialContact*>(this)->special_fdir1; }

void Contact::destroy()
{
    special() ? Pool<SpecialContact>::destroy(static_cast<SpecialContact*>(this))
              : Pool<Contact>::destroy(this);
}

namespace {

// What a contact joint is made of; mode and mu of `c.surface` first.
void structure_of_contact(dContact& c, StructureStream& stream)
{
    dSurfaceParameters& s = c.surface;
    stream.number(s.mode, 0, 1 << 16, "a contact joint of an unknown mode");
    stream.real(s.mu, StructureStream::kInfinite);
    stream.reals(c.geom.pos, 3), stream.reals(c.geom.normal, 3), stream.real(c.geom.depth);
    if (!Contact::is_special(s.mode)) return;
    // What the mode does not name may be anything.
    stream.numbers(&s.mu2, (sizeof(dSurfaceParameters) - offsetof(dSurfaceParameters, mu2)) / sizeof(Real));
    stream.numbers(c.fdir1, 3);
}

}  // namespace

void Contact::structure(StructureStream& stream)
{
    dContact c{};
    if (special()) c.surface = surface(), std::copy_n(fdir1(), 3, c.fdir1);
    c.surface.mode = mode, c.surface.mu = mu;
    store(c.geom.pos, pos), store(c.geom.normal, normal);
    c.geom.depth = depth;
    structure_of_contact(c, stream);
}

void Contact::describe(DifWriter& out) const
{
    const auto field = [&](int bit, const char* name, Real dSurfaceParameters::*member) {
        if (has(bit)) out.real(name, surface().*member);
    };
    epode::describe(out, "pos", pos);
    epode::describe(out, "normal", normal);
    out.real("depth", depth);
    out.real("mu", mu);
    field(dContactMu2, "mu2", &dSurfaceParameters::mu2);
    field(dContactRolling, "rho", &dSurfaceParameters::rho);
    if (has(dContactRolling)) field(dContactAxisDep, "rho2", &dSurfaceParameters::rho2);
    if (has(dContactRolling)) field(dContactAxisDep, "rhoN", &dSurfaceParameters::rhoN);
    field(dContactBounce, "bounce", &dSurfaceParameters::bounce);
    field(dContactBounce, "bounce_vel", &dSurfaceParameters::bounce_vel);
    field(dContactSoftERP, "soft_ERP", &dSurfaceParameters::soft_erp);
    field(dContactSoftCFM, "soft_CFM", &dSurfaceParameters::soft_cfm);
    field(dContactMotion1, "motion1", &dSurfaceParameters::motion1);
    field(dContactMotion2, "motion2", &dSurfaceParameters::motion2);
    field(dContactMotionN, "motionN", &dSurfaceParameters::motionN);
    field(dContactSlip1, "slip1", &dSurfaceParameters::slip1);
    field(dContactSlip2, "slip2", &dSurfaceParameters::slip2);
    // Approximations 1_1, 1_2 and 1_N as bits of a number.
    const int approximation = (mode & dContactApprox1) / dContactApprox1_1;
    if (approximation) out.integer("friction_approximation", approximation);
    if (has(dContactFDir1)) epode::describe(out, "fdir1", load(fdir1()));
}

bool SpecialContact::fits_manifold() const
{
    if (has(dContactRolling)) return false;
    if (!has(dContactMu2 | dContactAxisDep)) return true;
    return mu > 0 ? mu2() > 0 : !has(dContactAxisDep);
}

Row& Contact::contact_row(RowWriter& out, Vec3 d, RowKind kind) const
{
    return out.row(point_jacobian(*this, d, out.arms().r1, out.arms().r2), 0, kind);
}

void Contact::emit(RowWriter& out) const
{
    out.contact_at(pos - body1()->position(), body2() ? pos - body2()->position() : Vec3{});
    const Vec3 n = outward();
    aim_normal(contact_row(out, n, RowKind::kNormal), out.info(), n, touching_depth(out.info(), false));
    if (!sliding_at_all()) return;
    Vec3 t1, t2;
    tangents(n, t1, t2);
    write_sliding(out, t1, t2);
    if (has(dContactRolling)) write_rolling(out, t1, t2, n);
}

// All but the Jacobian.
inline void Contact::aim_normal(Row& row, const StepInfo& info, Vec3 n, Real touching_depth) const
{
    const Real excess = depth - info.contact_layer;
    row.error = excess > 0 ? excess : 0;
    row.speed = has(dContactMotionN) ? surface().motionN : 0;
    row.cap = info.contact_max_vel;
    if (has(dContactSoftERP)) row.erp = surface().soft_erp;
    if (has(dContactSoftCFM)) row.cfm = surface().soft_cfm;
    row.soft = has(dContactSoftERP | dContactSoftCFM);
    row.lo = 0;
    aim_rebound(row, n);
    if (depth < touching_depth) row.speed -= info.fps * (touching_depth - depth);
}

inline void Contact::aim_rebound(Row& row, Vec3 n) const
{
    if (!has(dContactBounce) || !(surface().bounce_vel >= 0)) return;
    const Vec3 v = body1()->point_velocity(pos) - (body2() ? body2()->point_velocity(pos) : Vec3{});
    const Real approach = row.speed - dot(n, v);
    row.has_restitution = approach > surface().bounce_vel;
    row.restitution_velocity = surface().bounce * approach + row.speed;
}

void Contact::tangents(Vec3 n, Vec3& t1, Vec3& t2) const
{
    plane_space(n, t1, t2);
    if (!has(dContactFDir1)) return;
    t1 = load(fdir1());
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
    if (mu > 0) {
        Row& row = contact_row(out, t1, RowKind::kFriction);
        if (has(dContactMotion1)) row.speed = surface().motion1;
        if (has(dContactSlip1)) row.cfm = surface().slip1, row.soft = true;
        bound(row, mu, dContactApprox1_1);
    }
    if (const Real mu2 = this->mu2(); mu2 > 0) {
        Row& row = contact_row(out, t2, RowKind::kFriction);
        if (has(dContactMotion2)) row.speed = surface().motion2;
        if (has(dContactSlip2)) row.cfm = surface().slip2, row.soft = true;
        bound(row, mu2, dContactApprox1_2);
    }
}

void Contact::write_rolling(RowWriter& out, Vec3 t1, Vec3 t2, Vec3 n) const
{
    const dSurfaceParameters& s = surface();
    const Vec3 axis[3] = {t1, t2, n};
    const Real rho[3] = {s.rho, has(dContactAxisDep) ? s.rho2 : s.rho, has(dContactAxisDep) ? s.rhoN : s.rho};
    constexpr int kApproximation[3] = {dContactApprox1_1, dContactApprox1_2, dContactApprox1_N};
    for (int i = 0; i < 3; ++i)
        if (rho[i] > 0)
            bound(out.row(angular_jacobian(*this, axis[i]), 0, RowKind::kFriction), rho[i],
                  kApproximation[i]);
}

namespace {

// Surface members that friction in the plane of contact depends on, in addition to mu and the approximation.
constexpr int kTangential =
    dContactMu2 | dContactFDir1 | dContactMotion1 | dContactMotion2 | dContactSlip1 | dContactSlip2;

bool joins(const Contact& last, const Contact& next)
{
    return last.body1() == next.body1() && last.body2() == next.body2() && last.normal == next.normal &&
           last.reverse == next.reverse && last.mode == next.mode && last.mu == next.mu &&
           !next.has(kTangential);
}

void set_friction(const Contact& contact, const StepInfo& info, JointManifold& m)
{
    const Real limit[2] = {contact.mu, contact.mu2()};
    const Real speed[2] = {contact.has(dContactMotion1) ? contact.surface().motion1 : 0,
                           contact.has(dContactMotion2) ? contact.surface().motion2 : 0};
    const Real cfm[2] = {contact.has(dContactSlip1) ? contact.surface().slip1 : info.cfm,
                         contact.has(dContactSlip2) ? contact.surface().slip2 : info.cfm};
    const bool share[2] = {contact.has(dContactApprox1_1), contact.has(dContactApprox1_2)};
    m.slips = contact.has(dContactSlip1 | dContactSlip2);
    contact.tangents(m.n, m.t1, m.t2);
    for (int k = 0; k < 2; ++k) {
        m.c[k] = speed[k];
        m.C[k] = cfm[k] * info.fps;
        m.mu[k] = share[k] ? limit[k] : 0;
        m.fixed[k] = share[k] ? 0 : limit[k] * info.h;
    }
}

// Both member by member into their place: there are thousands of them, and a copy of what has just been
// written in smaller pieces waits for them all.
void begin_manifold(const Contact& contact, const StepInfo& info, int first, JointManifold& m)
{
    const Body &a = *contact.body1(), *b = contact.body2();
    m.n = contact.outward();
    m.offset = b ? a.position() - b->position() : Vec3{};
    m.body1 = a.island_index, m.body2 = b ? b->island_index : -1;
    m.first = first, m.count = 0, m.cone = info.cone, m.slips = false;
    if (contact.sliding_at_all()) return set_friction(contact, info, m);
    m.t1 = m.t2 = {};
    for (int k = 0; k < 2; ++k) m.c[k] = m.C[k] = m.mu[k] = m.fixed[k] = 0;
}

inline void set_point(const Contact& contact, const StepInfo& info, Vec3 n, Real touching_depth,
                      JointManifoldPoint& point)
{
    Row row;
    row.erp = info.erp, row.cfm = info.cfm;
    contact.aim_normal(row, info, n, touching_depth);
    point.r1 = contact.pos - contact.body1()->position();
    point.c = wanted_velocity(row, info.correction * row.erp * info.fps);
    point.C = row.cfm * info.fps;
    point.error = row.error;
    for (Real& p : point.p) p = 0;
}

}  // namespace

Row normal_of_contact(const Joint& joint, const StepInfo& info)
{
    const Contact& contact = static_cast<const Contact&>(joint);
    Row row;
    row.erp = info.erp, row.cfm = info.cfm;
    row.kind = RowKind::kNormal;
    contact.aim_normal(row, info, contact.outward(), contact.touching_depth(info, false));
    return row;
}

ContactPlace place_of_contact(const Joint& joint)
{
    const Contact& contact = static_cast<const Contact&>(joint);
    return {contact.pos, contact.outward(), contact.depth};
}

namespace {

// Sweeps settle a point alone to rounding; of several some are left to part.
Real touching_depth(std::span<Joint* const> contacts, std::size_t i, const StepInfo& info)
{
    const Contact& contact = static_cast<const Contact&>(*contacts[i]);
    const auto of_same_bodies = [&](std::size_t k) {
        return k < contacts.size() && contacts[k]->body1() == contact.body1() &&
               contacts[k]->body2() == contact.body2();
    };
    return contact.touching_depth(info, of_same_bodies(i + 1) || of_same_bodies(i - 1));
}

}  // namespace

void write_manifolds(std::span<Joint* const> contacts, const StepInfo& info, JointManifoldList& out)
{
    constexpr int kLines = 3;  // of a contact without special surface
    constexpr std::size_t kAhead = 8;
    std::size_t manifolds = 0;
    const Contact* last = nullptr;
    for_each_prefetched<kLines, 2 * kAhead>(contacts, [&](std::size_t i, const Joint& joint) {
        if (i + kAhead < contacts.size())
            for (const JointNode& node : contacts[i + kAhead]->node)
                if (node.body) prefetch<2>(node.body);
        const Contact& contact = static_cast<const Contact&>(joint);
        if (!last || !joins(*last, contact) || out.manifolds[manifolds - 1].count == kManifoldPoints)
            begin_manifold(contact, info, int(i), out.manifolds[manifolds++]);
        JointManifold& m = out.manifolds[manifolds - 1];
        set_point(contact, info, m.n, touching_depth(contacts, i, info), out.points[i]);
        ++m.count;
        last = &contact;
    });
    out.manifolds = out.manifolds.first(manifolds);
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
    const Real n2 = length2(load(g.normal)), all = length2(load(g.pos)) + n2 + g.depth * g.depth;
    return within(all, kMaxMagnitude * kMaxMagnitude) && n2 > 0;
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

Joint* Contact::make(World& world, StructureStream& stream)
{
    dContact c{};
    structure_of_contact(c, stream);
    if (!stream.demand(usable_contact(c), "a contact joint with a number that it cannot have"))
        return nullptr;
    const JointType& type = kContactType;
    if (is_special(c.surface.mode)) return Pool<SpecialContact>::create(type, world, c);
    return Pool<Contact>::create(type, world, c);
}

}  // namespace epode

using namespace epode;

extern "C" dJointID dJointCreateContact(dWorldID w, dJointGroupID g, const dContact* contact)
{
    EPODE_USER(contact && usable_contact(*contact), nullptr);
    return Contact::is_special(contact->surface.mode)
               ? create_joint_for<SpecialContact>(__func__, w, g, *contact)
               : create_joint_for<Contact>(__func__, w, g, *contact);
}
