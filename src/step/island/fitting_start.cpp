// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/fitting_start.h"

#include <algorithm>

#include "rows/policy.h"
#include "step/island/positions/solved_motion.h"

namespace epode {
namespace {

constexpr double kShare = 0.1, kSpeed = 0.3;  // of the energy at v*, and m/s of all bodies

struct Impulse {
    Vec3 linear, angular;
};
struct BodyImpulses {
    Impulse start, given;  // J^T p of a body, and of the rows whose impulse is no unknown
};

bool is_given(const RowNumbers& n) { return n.parent < 0 && n.lo == n.hi; }

class Start {
  public:
    Start(RowSystem& system, std::span<Body* const> bodies, int substeps, int part,
          std::span<BodyImpulses> impulses)
        : system_(system),
          bodies_(bodies),
          substeps_(substeps),
          from_(system.begin_of(part)),
          to_(system.end_of(part)),
          impulses_(impulses)
    {}

    void fit()
    {
        for (int k = from_.blocks; k < to_.blocks; ++k) add(system_.blocks[std::size_t(k)]);
        for (int k = from_.joint_manifolds; k < to_.joint_manifolds; ++k) add(manifold(k));
        for (int k = from_.contact_manifolds; k < to_.contact_manifolds; ++k) add(world_manifold(k));
        for (int i = from_.bodies; i < to_.bodies; ++i) add_motion(std::size_t(i));
        const double made = linear_ + square_ / 2, believed = kSpeed * kSpeed * mass_ / 2;
        if (!(made > believed) || !(made > believed + kShare * energy())) return;
        const Real share = linear_ < 0 ? Real(-linear_ / square_) : Real(0);
        for (int k = from_.blocks; k < to_.blocks; ++k) scale(system_.blocks[std::size_t(k)], share);
        for (int k = from_.joint_manifolds; k < to_.joint_manifolds; ++k) scale(manifold(k), share);
        for (int k = from_.contact_manifolds; k < to_.contact_manifolds; ++k)
            scale_impulses(world_manifold(k), float(share));
    }

  private:
    const JointManifold& manifold(int k) const { return system_.joint_contacts.manifolds[std::size_t(k)]; }
    ContactManifold& world_manifold(int k) const { return *system_.contact_manifolds[std::size_t(k)]; }
    std::span<JointManifoldPoint> points(const JointManifold& m) const
    {
        return system_.joint_contacts.points.subspan(std::size_t(m.first), std::size_t(m.count));
    }
    std::span<RowNumbers> numbers(const RowBlock& block) const
    {
        return system_.numbers.subspan(std::size_t(block.first), std::size_t(block.count));
    }

    void add_impulse(Impulse BodyImpulses::*which, int body, const Impulse& p)
    {
        if (body < 0) return;
        Impulse& sum = impulses_[std::size_t(body)].*which;
        sum.linear += p.linear, sum.angular += p.angular;
    }
    void add_impulse(int body, Vec3 linear, Vec3 angular)
    {
        add_impulse(&BodyImpulses::start, body, {linear, angular});
    }

    void count(Real p, Real c, Real C)
    {
        linear_ -= double(p) * double(c);
        square_ += share_ * double(p) * double(p) * double(C);
    }

    // In substeps numbers are those of each: here c is that of the whole step, and only a drive's softness counts.
    void count(const RowBlock& block, const Row& row, const RowNumbers& n)
    {
        if (substeps_ == 0) return count(n.p, n.c, n.C);
        if (row.drive) {
            const DriveAim aim = drive_aim(*row.drive, system_.h / Real(substeps_));
            return count(n.p, aim.speed + aim.rate * row.error, aim.C);
        }
        count(n.p, block.contact ? row.speed : row.speed + row.erp * per_h_ * row.error, 0);
    }

    void add(const RowBlock& block)
    {
        Impulse on1{}, on2{};
        for (int i = block.first; i < block.first + block.count; ++i) {
            const RowNumbers& n = system_.numbers[std::size_t(i)];
            const Row& row = system_.rows[std::size_t(i)];
            if (is_given(n) || block.term_count > 0) {
                add_alone(block, row, n);
            } else if (n.p != 0) {
                count(block, row, n);
                on1.linear += n.p * row.lin1, on1.angular += n.p * row.ang1;
                on2.linear += n.p * row.lin2, on2.angular += n.p * row.ang2;
            }
        }
        if (block.term_count > 0) return;
        add_impulse(&BodyImpulses::start, block.body1, on1),
            add_impulse(&BodyImpulses::start, block.body2, on2);
    }

    void add_alone(const RowBlock& block, const Row& row, const RowNumbers& n)
    {
        const bool given = is_given(n);
        const auto which = given ? &BodyImpulses::given : &BodyImpulses::start;
        const Real p = given ? n.hi : n.p;
        if (!given) count(block, row, n);
        for (const WideTerm& term : terms_of(system_, block))
            add_impulse(which, term.body, {p * term.lin, p * term.ang});
        if (block.term_count > 0) return;
        add_impulse(which, block.body1, {p * row.lin1, p * row.ang1});
        add_impulse(which, block.body2, {p * row.lin2, p * row.ang2});
    }

    void add(const JointManifold& m)
    {
        for (const JointManifoldPoint& point : points(m)) {
            const Vec3 p = point.p[0] * m.n + point.p[1] * m.t1 + point.p[2] * m.t2;
            count(point.p[0], point.c, point.C);
            for (int i = 0; i < 2; ++i) count(point.p[i + 1], m.c[i], m.C[i]);
            add_impulse(m.body1, p, cross(point.r1, p));
            add_impulse(m.body2, -p, -cross(point.r1 + m.offset, p));
        }
    }

    void add(const ContactManifold& m)
    {
        for (int i = 0; i < m.count; ++i) {
            const ManifoldPoint& point = m.points[i];
            const Vec3 friction = widen(point.friction_impulse);
            const Vec3 p = Real(point.normal_impulse) * widen(m.normal) + friction;
            linear_ -= double(dot(friction, widen(m.surface_velocity)));
            add_impulse(m.body1, p, cross(widen(point.r1), p));
            add_impulse(m.body2, -p, -cross(widen(point.r2), p));
        }
    }

    // v* with the forces and given impulses of the first substep, or of the step, where the system's v* has the forces.
    SolverBody forced(std::size_t i) const
    {
        SolverBody body = system_.bodies[i];
        const Real hs = substeps_ > 0 ? system_.h / Real(substeps_) : 0;
        const Impulse& given = impulses_[i].given;
        body.v += body.inv_mass * (hs * load(bodies_[i]->facc) + Real(share_) * given.linear);
        body.w += body.inv_inertia * (hs * load(bodies_[i]->tacc) + Real(share_) * given.angular);
        return body;
    }

    void add_motion(std::size_t i)
    {
        if (moves_by_itself(system_.bodies[i])) return add_driven(system_.bodies[i], impulses_[i].start);
        const SolverBody body = forced(i);
        const Impulse& start = impulses_[i].start;
        add_driven(body, start);
        square_ += share_ * double(body.inv_mass * length2(start.linear) +
                                   dot(start.angular, body.inv_inertia * start.angular));
        mass_ += double(bodies_[i]->mass.mass);
    }

    double energy() const
    {
        double sum = 0;
        for (auto i = std::size_t(from_.bodies); i < std::size_t(to_.bodies); ++i) {
            if (moves_by_itself(system_.bodies[i])) continue;
            const SolverBody body = forced(i);
            sum += kinetic_of(*bodies_[i], body.v, transposed_times(bodies_[i]->rotation(), body.w));
        }
        return sum;
    }

    void add_driven(const SolverBody& body, const Impulse& start)
    {
        linear_ += double(dot(start.linear, body.v) + dot(start.angular, body.w));
    }

    void scale(const RowBlock& block, Real share) const
    {
        for (RowNumbers& n : numbers(block))
            if (!is_given(n)) n.p *= share;
    }
    void scale(const JointManifold& m, Real share) const
    {
        for (JointManifoldPoint& point : points(m))
            for (Real& p : point.p) p *= share;
    }

    RowSystem& system_;
    const std::span<Body* const> bodies_;
    const int substeps_;
    const double share_ = 1.0 / std::max(1, substeps_);
    const Real per_h_ = 1 / system_.h;
    const SystemPart from_, to_;
    const std::span<BodyImpulses> impulses_;  // of all bodies of the system
    double linear_ = 0, square_ = 0;          // a and b
    double mass_ = 0;
};

}  // namespace

void fit_start(RowSystem& system, std::span<Body* const> bodies, int substeps, Arena& arena)
{
    Arena::Scope scope(arena);
    const auto impulses = arena.take_zeroed<BodyImpulses>(int(system.bodies.size()));
    if (impulses.empty()) return;
    for (int part = 0; part < system.worlds(); ++part) Start(system, bodies, substeps, part, impulses).fit();
}

}  // namespace epode
