// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/energy_ledger.h"

#include <algorithm>

#include "dynamics/integrate.h"
#include "joints/joint_manifolds.h"
#include "solve/common/substep_rows.h"

namespace epode {
namespace {

double kinetic(const Body& body, Vec3 v, Vec3 w)
{
    const Vec3 local = transposed_times(body.rotation(), w);
    const double m = body.mass.mass;
    return 0.5 * (m * double(length2(v)) + double(dot(local, body.inertia * local)));
}

// What the body's own damping will take at the step's end.
double damping_of(const Body& body)
{
    const Vec3 v = body.velocity(), w = body.angular_velocity();
    const Vec3 slower = damps_motion(body) ? (1 - body.damping.linear_scale) * v : v;
    const Vec3 less_spin = damps_spin(body) ? (1 - body.damping.angular_scale) * w : w;
    return slower == v && less_spin == w ? 0 : kinetic(body, slower, less_spin) - kinetic(body, v, w);
}

// The velocity nearest to u between 0 and `target`.
Real limited(Real u, Real target)
{
    return target > 0 ? std::clamp(u, Real(0), target) : std::clamp(u, target, Real(0));
}

// Impulse of a row, its velocities before and after, and the target of its correction.
struct RowWork {
    Real p, before, after, correction;
    double whole() const { return 0.5 * double(p) * (double(before) + double(after)); }
    double of_correction() const
    {
        return 0.5 * double(p) * (double(limited(before, correction)) + double(limited(after, correction)));
    }
};

bool is_motor(const Row& row) { return row.kind == RowKind::kLimit && row.erp == 0 && row.error == 0; }

// The part of the target velocity c that corrects the row's error. Where the solver has relaxed it, what a
// contact that does not bounce has left of it.
Real correction_in(const Row& row, Real c, bool relaxed)
{
    if (row.has_restitution && (relaxed || c == row.restitution_velocity)) return 0;
    if (relaxed) return row.kind == RowKind::kLock ? 0 : row.lo >= 0 ? kInf : -kInf;
    const Real correction = c - row.speed;
    if (row.kind == RowKind::kLock) return correction;
    return row.lo >= 0 ? std::max(correction, Real(0)) : std::min(correction, Real(0));
}

// Compliance beyond what only keeps the problem well-posed; `d`: the row's inverse effective mass.
bool is_soft(const Row& row, Real d, Real h)
{
    return row.drive || row.cfm > std::max(kDefaultCfm, kSoftShare * d * h);
}

void add_normal(bool soft, const RowWork& work, dEnergyLedger& to)
{
    const double corrected = soft ? 0 : work.of_correction();
    to.correction += corrected;
    (soft ? to.drives : to.impacts) += work.whole() - corrected;
}

// The friction of one contact or joint: its impulse times its slips before and after, summed over its directions.
struct Slip {
    double before = 0, after = 0;
    // Friction only ever brakes: of each slip what it opposes is its own, the rest that of what made the other slip.
    void add_to(double& friction, double& rest) const
    {
        const double braked = 0.5 * (std::min(before, 0.0) + std::min(after, 0.0));
        friction += braked, rest += 0.5 * (before + after) - braked;
    }
};

void add_slip(const Row& row, const RowWork& work, Slip& slip, dEnergyLedger& to)
{
    const double p = double(work.p), speed = double(row.speed);
    to.drives += p * speed;
    slip.before += p * (double(work.before) - speed), slip.after += p * (double(work.after) - speed);
}

void add_row(const Row& row, bool soft, const RowWork& work, Slip& slip, dEnergyLedger& to)
{
    const double whole = work.whole();
    if (row.kind == RowKind::kFriction) {
        add_slip(row, work, slip, to);
    } else if (row.kind != RowKind::kLock) {
        add_normal(soft || is_motor(row), work, to);
    } else if (soft) {
        to.drives += whole;
    } else {
        to.correction += work.of_correction();
        to.joints += whole - work.of_correction();
    }
}

bool is_kinematic(const SolverBody& body) { return !(body.inv_mass > 0); }

// Of an impulse P on body 1 and -P on body 2, at arms r1 and r2 of their centres.
class PointMotion {
  public:
    PointMotion(std::span<const SolverBody> bodies, int body1, int body2, Vec3 r1, Vec3 r2)
        : v1_(velocity(bodies, body1, r1)), v2_(velocity(bodies, body2, r2))
    {
        if (body1 >= 0 && is_kinematic(bodies[std::size_t(body1)])) driven_ = v1_;
        if (body2 >= 0 && is_kinematic(bodies[std::size_t(body2)])) driven_ -= v2_;
    }
    Vec3 relative() const { return v1_ - v2_; }
    double supply(Vec3 P) const { return -double(dot(P, driven_)); }

  private:
    static Vec3 velocity(std::span<const SolverBody> bodies, int body, Vec3 r)
    {
        if (body < 0) return {};
        const SolverBody& b = bodies[std::size_t(body)];
        return b.v + cross(b.w, r);
    }
    Vec3 v1_, v2_, driven_;
};

// What kinematic bodies put in by a row.
double supply_of(const RowSystem& system, const RowBlock& block, const Row& row, Real p)
{
    double sum = 0;
    const auto add = [&](int body, Vec3 lin, Vec3 ang) {
        if (body < 0) return;
        const SolverBody& b = system.bodies[std::size_t(body)];
        if (is_kinematic(b)) sum -= double(p) * double(dot(lin, b.v) + dot(ang, b.w));
    };
    for (const WideTerm& term : terms_of(system, block)) add(term.body, term.lin, term.ang);
    if (block.term_count > 0) return sum;
    add(block.body1, row.lin1, row.ang1), add(block.body2, row.lin2, row.ang2);
    return sum;
}

double sum_of_shares(const dEnergyLedger& l)
{
    return l.gravity + l.forces + l.drives + l.friction + l.impacts + l.joints + l.damping + l.correction;
}

// All that follows from the present poses and velocities.
void close(const World& world, const Island& island, dEnergyLedger& ledger)
{
    ledger.kinetic_after = ledger.potential_after = ledger.damping = 0;
    for (const Body* body : island.bodies) {
        const BodyEnergy now = energy_of(world, *body);
        ledger.kinetic_after += now.kinetic, ledger.potential_after += now.potential;
        if (!body->kinematic()) ledger.damping += damping_of(*body);
    }
    ledger.kinetic_after += ledger.damping;
    ledger.gravity = ledger.potential_before - ledger.potential_after;
    ledger.integration = ledger.kinetic_after - ledger.kinetic_before - sum_of_shares(ledger);
}

}  // namespace

BodyEnergy energy_of(const World& world, const Body& body)
{
    if (body.kinematic()) return {0, 0};
    const double m = body.mass.mass;
    return {kinetic(body, body.velocity(), body.angular_velocity()),
            body.gravity ? -m * double(dot(world.gravity, body.position())) : 0};
}

bool EnergyLedger::begin(Arena& arena)
{
    motion_ = arena.take<SolverBody>(int(bodies_.size()));
    before_ = arena.take<Before>(int(bodies_.size()));
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body& body = *bodies_[i];
        before_[i] = {body.position(), body.velocity(), body.angular_velocity(), load(body.facc),
                      load(body.tacc)};
    }
    load_motion();
    for (std::size_t i = 0; i < out_.size(); ++i) {
        dEnergyLedger& to = out_[i] = {};
        to.struct_size = sizeof to, to.islands = 1, to.body = to_handle(members_[i].bodies[0]);
        for (const Body* body : members_[i].bodies) {
            const BodyEnergy now = energy_of(world_, *body);
            to.kinetic_before += now.kinetic, to.potential_before += now.potential;
        }
    }
    return true;
}

void EnergyLedger::load_motion()
{
    for (std::size_t i = 0; i < motion_.size(); ++i) {
        motion_[i].inv_mass = bodies_[i]->inv_mass;
        load_velocity(*bodies_[i], motion_[i]);
    }
}

void EnergyLedger::add_solution(const IslandWork& work, int part, bool relaxed)
{
    dEnergyLedger& to = out_[std::size_t(part)];
    const RowSystem& system = work.system;
    const SystemPart from = system.begin_of(part), end = system.end_of(part);
    for (int k = from.blocks; k < end.blocks; ++k) add_rows(work, system.blocks[std::size_t(k)], relaxed, to);
    for (int k = from.joint_manifolds; k < end.joint_manifolds; ++k)
        add_contacts(work, system.joint_contacts.manifolds[std::size_t(k)], to);
    for (int k = from.contact_manifolds; k < end.contact_manifolds; ++k)
        add_manifold(work, *system.contact_manifolds[std::size_t(k)], to);
}

// In the accumulators are the program's forces, the weight, and what joints have added: motors at their stops.
void EnergyLedger::add_forces(int part, Real h)
{
    dEnergyLedger& to = out_[std::size_t(part)];
    const auto& members = members_[std::size_t(part)].bodies;
    const std::size_t first = first_body(part);
    for (std::size_t i = first; i < first + members.size(); ++i) {
        const Body& body = *members[i - first];
        if (body.kinematic()) continue;
        const Before& b = before_[i];
        const Vec3 v = b.v + body.velocity(), w = b.w + body.angular_velocity();
        const Vec3 known = body.gravity ? b.force + body.mass.mass * world_.gravity : b.force;
        const Real half = h / 2;
        to.forces += double(half * (dot(b.force, v) + dot(b.torque, w)));
        to.drives += double(half * (dot(load(body.facc) - known, v) + dot(load(body.tacc) - b.torque, w)));
    }
}

void EnergyLedger::add_rows(const IslandWork& work, const RowBlock& block, bool relaxed,
                            dEnergyLedger& to) const
{
    const RowSystem& system = work.system;
    Slip slip;
    for (int i = block.first; i < block.first + block.count; ++i) {
        const Row& row = system.rows[std::size_t(i)];
        const RowNumbers& n = system.numbers[std::size_t(i)];
        if (n.p == 0) continue;
        const Real d = inverse_effective_mass(system, block, row, system.bodies);
        const RowWork done{n.p, row_velocity(system, block, row, motion_),
                           row_velocity(system, block, row, system.bodies), correction_in(row, n.c, relaxed)};
        add_row(row, is_soft(row, d, system.h), done, slip, to);
        to.drives += supply_of(system, block, row, n.p);
    }
    slip.add_to(to.friction, block.contact ? to.impacts : to.joints);
}

void EnergyLedger::add_contacts(const IslandWork& work, const JointManifold& m, dEnergyLedger& to) const
{
    const RowSystem& system = work.system;
    const StepInfo info = step_info(world_, system.h);
    for (auto i = std::size_t(m.first); i < std::size_t(m.first + m.count); ++i) {
        const JointManifoldPoint& point = system.joint_contacts.points[i];
        const Vec3 r1 = point.r1, r2 = point.r1 + m.offset;
        const PointMotion before(motion_, m.body1, m.body2, r1, r2),
            after(system.bodies, m.body1, m.body2, r1, r2);
        Row normal = normal_of_contact(*work.contacts[i], info);
        static_cast<Jacobian&>(normal) = {m.n, cross(r1, m.n), -m.n, -cross(r2, m.n)};
        const SolverBody* const second = m.body2 < 0 ? nullptr : &system.bodies[std::size_t(m.body2)];
        const Real d = inverse_effective_mass(normal, system.bodies[std::size_t(m.body1)], second);
        Slip slip;
        add_row(normal, is_soft(normal, d, system.h),
                {point.p[0], dot(m.n, before.relative()), dot(m.n, after.relative()),
                 correction_in(normal, point.c, false)},
                slip, to);
        const Vec3 t[2] = {m.t1, m.t2};
        Row friction;
        for (int k = 0; k < 2; ++k) {
            friction.speed = m.c[k];
            add_slip(friction, {point.p[k + 1], dot(t[k], before.relative()), dot(t[k], after.relative()), 0},
                     slip, to);
        }
        slip.add_to(to.friction, to.impacts);
        to.drives += after.supply(point.p[0] * m.n + point.p[1] * m.t1 + point.p[2] * m.t2);
    }
}

void EnergyLedger::add_manifold(const IslandWork& work, const ContactManifold& m, dEnergyLedger& to) const
{
    const std::span<const SolverBody> bodies = work.system.bodies;
    const Vec3 n = widen(m.normal), belt = widen(m.surface_velocity);
    const bool bounces = m.restitution > 0;
    for (int i = 0; i < m.count; ++i) {
        const ManifoldPoint& point = m.points[i];
        const Vec3 r1 = widen(point.r1), r2 = widen(point.r2), slide = widen(point.friction_impulse);
        const PointMotion before(motion_, m.body1, m.body2, r1, r2), after(bodies, m.body1, m.body2, r1, r2);
        const Real p = Real(point.normal_impulse);
        const RowWork normal{p, dot(n, before.relative()), dot(n, after.relative()), bounces ? 0 : kInf};
        add_normal(m.compliance > 0, normal, to);
        to.drives += double(dot(slide, belt)) + after.supply(p * n + slide);
        Slip{double(dot(slide, before.relative() - belt)), double(dot(slide, after.relative() - belt))}
            .add_to(to.friction, to.impacts);
    }
    if (m.rolling_friction > 0) add_rolling(bodies, m, to);
}

void EnergyLedger::add_rolling(std::span<const SolverBody> bodies, const ContactManifold& m,
                               dEnergyLedger& to) const
{
    const Vec3 couple = widen(m.rolling_impulse);
    const auto spin = [](std::span<const SolverBody> all, int body) {
        return body < 0 ? Vec3{} : all[std::size_t(body)].w;
    };
    const auto driven = [&](int body) {
        return body >= 0 && is_kinematic(bodies[std::size_t(body)]) ? spin(bodies, body) : Vec3{};
    };
    Slip{double(dot(couple, spin(motion_, m.body1) - spin(motion_, m.body2))),
         double(dot(couple, spin(bodies, m.body1) - spin(bodies, m.body2)))}
        .add_to(to.friction, to.impacts);
    to.drives -= double(dot(couple, driven(m.body1) - driven(m.body2)));
}

void EnergyLedger::add_relaxed_corrections(int part, std::span<const Velocity> ends, Real substep)
{
    const auto& members = members_[std::size_t(part)].bodies;
    const std::size_t first = first_body(part);
    for (std::size_t i = first; i < first + members.size(); ++i) {
        const Body& body = *members[i - first];
        if (body.kinematic() || !body.gravity) continue;
        const Vec3 way = body.position() - before_[i].x - substep * ends[i].v;
        out_[std::size_t(part)].correction -= double(body.mass.mass * dot(world_.gravity, way));
    }
}

double EnergyLedger::energy_of_member(std::size_t i) const
{
    double sum = 0;
    for (const Body* body : members_[i].bodies) {
        const BodyEnergy now = energy_of(world_, *body);
        sum += now.kinetic + now.potential;
    }
    return sum;
}

void EnergyLedger::begin_correction()
{
    for (std::size_t i = 0; i < out_.size(); ++i) out_[i].correction -= energy_of_member(i);
}

void EnergyLedger::end_correction()
{
    for (std::size_t i = 0; i < out_.size(); ++i) out_[i].correction += energy_of_member(i);
}

void EnergyLedger::forget()
{
    for (dEnergyLedger& to : out_)
        to.forces = to.drives = to.friction = to.impacts = to.joints = to.correction = 0;
}

void EnergyLedger::end()
{
    for (std::size_t i = 0; i < out_.size(); ++i) close(world_, members_[i], out_[i]);
}

void add_stop(const World& world, const Island& island, dEnergyLedger& ledger)
{
    const double before = ledger.kinetic_after - ledger.damping + ledger.potential_after;
    close(world, island, ledger);
    const double moved = ledger.kinetic_after - ledger.damping + ledger.potential_after - before;
    ledger.correction += moved, ledger.integration -= moved;
}

dEnergyLedger sum_of(std::span<const dEnergyLedger> islands)
{
    dEnergyLedger sum{};
    sum.struct_size = sizeof sum;
    sum.islands = int(islands.size());
    constexpr double dEnergyLedger::*kAdded[] = {
        &dEnergyLedger::kinetic_before,  &dEnergyLedger::kinetic_after, &dEnergyLedger::potential_before,
        &dEnergyLedger::potential_after, &dEnergyLedger::gravity,       &dEnergyLedger::forces,
        &dEnergyLedger::drives,          &dEnergyLedger::friction,      &dEnergyLedger::impacts,
        &dEnergyLedger::joints,          &dEnergyLedger::damping,       &dEnergyLedger::correction,
        &dEnergyLedger::integration};
    for (const dEnergyLedger& one : islands)
        for (const auto share : kAdded) sum.*share += one.*share;
    return sum;
}

}  // namespace epode
