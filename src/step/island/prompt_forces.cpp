// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/prompt_forces.h"

#include <algorithm>
#include <cmath>

#include "step/island/problem/joint_memory.h"

namespace epode {
namespace {

constexpr int kSweeps = 20;
constexpr Real kSettled = Real(1e-3);  // velocity that is left, of the fastest that forces alone would give
constexpr Real kLeastShare = Real(0.05);   // of the last impulses: a smaller one would only spread the work
constexpr Real kSpringShare = Real(1e-3);  // of the inverse effective mass: softer rows are springs
constexpr Real kSliding = Real(0.98);      // friction above this share of its bound may slide

// A row that may hold; dp is what it adds to its impulse of the last step.
struct Bearing {
    Jacobian J;
    int body1, body2;  // below zero: the world
    Real p;
    Real lo, hi;           // of dp
    const RowBlock* wide;  // of a coupling, else null
    Real d = 0, dp = 0;    // J M^-1 J^T
};

class PromptForces {
  public:
    PromptForces(const World& world, IslandWork& work, Real h, Real warm_share, Arena& arena)
        : world_(world), work_(work), system_(work.system), h_(h), unscale_(1 / warm_share), arena_(arena)
    {}

    bool any() const
    {
        return std::any_of(work_.island.bodies.begin(), work_.island.bodies.end(),
                           [&](const Body* b) { return is_pushed(*b); });
    }

    // False: out of memory.
    bool find()
    {
        const int bodies = int(system_.bodies.size());
        kicked_ = arena_.take<SolverBody>(bodies), borne_ = arena_.take_zeroed<BorneForce>(bodies);
        rows_ = arena_.take<Bearing>(row_limit());
        if (arena_.failed()) return false;
        load_bodies();
        for (int part = 0; part < system_.worlds(); ++part) find_in(part);
        return true;
    }

    std::span<const BorneForce> apply()
    {
        for (std::size_t i = 0; i < borne_.size(); ++i) {
            SolverBody& body = system_.bodies[i];
            body.v += kicked_[i].v, body.w += kicked_[i].w;
            borne_[i].force = borne_[i].force * (-1 / h_), borne_[i].torque = borne_[i].torque * (-1 / h_);
        }
        return borne_;
    }

  private:
    bool is_pushed(const Body& body) const
    {
        return !body.kinematic() && (!(load(body.tacc) == Vec3{}) || !(force_on(world_, body) == Vec3{}));
    }

    void load_bodies()
    {
        for (std::size_t i = 0; i < kicked_.size(); ++i) {
            const Body& body = *work_.island.bodies[i];
            SolverBody& to = kicked_[i];
            to = system_.bodies[i], to.v = to.w = {};
            if (!is_pushed(body)) continue;
            to.v = (h_ * to.inv_mass) * force_on(world_, body);
            to.w = h_ * (to.inv_inertia * load(body.tacc));
        }
    }

    int row_limit() const
    {
        return int(system_.rows.size()) + 3 * kManifoldPoints * int(system_.contact_manifolds.size());
    }

    // Parts do not know each other: what one does must not end the sweeps of another.
    void find_in(int part)
    {
        const SystemPart from = system_.begin_of(part), to = system_.end_of(part);
        count_ = 0, fastest_ = 0;
        list_rows(from, to);
        begin_from_last(std::size_t(from.bodies), std::size_t(to.bodies));
        for (int i = 0; i < kSweeps && sweep(); ++i) {}
    }

    void list_rows(const SystemPart& from, const SystemPart& to)
    {
        for (int k = from.blocks; k < to.blocks; ++k) {
            const RowBlock& block = system_.blocks[std::size_t(k)];
            for (int i = 0; i < block.count; ++i) list_row(block, i, last_impulse(k, i));
        }
        for (int k = from.contact_manifolds; k < to.contact_manifolds; ++k) {
            const ContactManifold& manifold = *system_.contact_manifolds[std::size_t(k)];
            for (int i = 0; i < manifold.count; ++i) list_point(manifold, manifold.points[i]);
        }
    }

    // Of row i of block k: joints keep another share of theirs than contacts (step/island/problem/joint_memory.h).
    Real last_impulse(int k, int i) const
    {
        const RowBlock& block = system_.blocks[std::size_t(k)];
        const Real kept = system_.numbers[std::size_t(block.first + i)].p;
        if (block.contact || kept == 0) return unscale_ * kept;
        const LastingJoint& joint = lasting(*work_.joints[std::size_t(k)]);
        return step_ratio(joint, system_.h) * joint.impulse[i];
    }

    void list_row(const RowBlock& block, int index, Real p)
    {
        const auto i = std::size_t(block.first + index);
        const Row& row = system_.rows[i];
        const RowNumbers& n = system_.numbers[i];
        if (row.kind == RowKind::kNormal && !(n.p > 0) && row.error < 0) return;
        Bearing to{row, block.body1, block.body2, p, -kInf, kInf, block.term_count > 0 ? &block : nullptr};
        const Real d = inverse_effective_mass(system_, block, row, system_.bodies);
        if (n.C > kSpringShare * d) {
            limit(to, false, false);
        } else if (n.parent >= 0) {
            const Real bound = unscale_ * n.hi * system_.numbers[std::size_t(n.parent)].p;
            const Real slip = row_velocity(system_, block, row, system_.bodies) - n.c;
            if (slides(std::fabs(p), bound, std::fabs(slip), d)) limit(to, false, false);
        } else {
            limit(to, p > n.lo, p < n.hi);
        }
        add(to);
    }

    void list_point(const ContactManifold& manifold, const ManifoldPoint& point)
    {
        const Real p = Real(point.normal_impulse);
        if (!(p > 0) && point.separation > 0) return;
        const Vec3 n = widen(manifold.normal), slide = widen(point.friction_impulse);
        const auto along = [&](Vec3 d, Real impulse, bool gives, bool takes) {
            Bearing to{{d, cross(widen(point.r1), d), -d, -cross(widen(point.r2), d)},
                       manifold.body1,
                       manifold.body2,
                       impulse,
                       -kInf,
                       kInf,
                       nullptr};
            limit(to, gives, takes);
            add(to);
        };
        along(n, p, p > 0, true);
        if (!(p > 0)) return;
        if (slides(manifold, point)) {
            const Real size = length(slide);
            if (size > 0) along(slide / size, size, false, false);
            return;
        }
        Vec3 t1, t2;
        plane_space(n, t1, t2);
        along(t1, dot(slide, t1), true, true), along(t2, dot(slide, t2), true, true);
    }

    // A row that can give no less, or take no more, than it does bears at most what it does.
    static void limit(Bearing& row, bool gives, bool takes)
    {
        if (!gives) row.lo = std::min(row.p, Real(0));
        if (!takes) row.hi = std::max(row.p, Real(0));
    }

    // Friction p with that bound, at a slip that it could not stop within the step; d: velocity per impulse.
    static bool slides(Real p, Real bound, Real slip, Real d)
    {
        return !(p < kSliding * bound) && !(slip < bound * d);
    }

    bool slides(const ContactManifold& manifold, const ManifoldPoint& point) const
    {
        const Vec3 n = widen(manifold.normal);
        Vec3 u = -widen(manifold.surface_velocity);
        Real d = 0;
        const auto add_end = [&](int body, Vec3 r, Real sign) {
            if (body < 0) return;
            const SolverBody& b = system_.bodies[std::size_t(body)];
            u += sign * (b.v + cross(b.w, r)), d += b.inv_mass;
        };
        add_end(manifold.body1, widen(point.r1), 1), add_end(manifold.body2, widen(point.r2), -1);
        return slides(friction_size(manifold, widen(point.friction_impulse)),
                      largest_mu(manifold) * Real(point.normal_impulse), length(u - dot(n, u) * n), d);
    }

    void add(const Bearing& row)
    {
        Bearing& to = rows_[count_];
        to = row;
        to.d = freedom_of(row);
        if (to.d > 0) ++count_;
    }

    Real freedom_of(const Bearing& row) const
    {
        Real sum = 0;
        for_bodies(row, [&](int body, Vec3 lin, Vec3 ang) {
            const SolverBody& b = kicked_[std::size_t(body)];
            sum += b.inv_mass * length2(lin) + dot(ang, b.inv_inertia * ang);
        });
        return sum;
    }

    // f(body, lin, ang) for each body that the row acts on.
    template <typename F>
    void for_bodies(const Bearing& row, const F& f) const
    {
        if (row.wide) {
            for (const WideTerm& term : terms_of(system_, *row.wide)) f(term.body, term.lin, term.ang);
            return;
        }
        if (row.body1 >= 0) f(row.body1, row.J.lin1, row.J.ang1);
        if (row.body2 >= 0) f(row.body2, row.J.lin2, row.J.ang2);
    }

    Real velocity_of(const Bearing& row) const
    {
        Real u = 0;
        for_bodies(row, [&](int body, Vec3 lin, Vec3 ang) {
            const SolverBody& b = kicked_[std::size_t(body)];
            u += dot(lin, b.v) + dot(ang, b.w);
        });
        return u;
    }

    void push(const Bearing& row, Real dp)
    {
        for_bodies(row, [&](int body, Vec3 lin, Vec3 ang) {
            SolverBody& b = kicked_[std::size_t(body)];
            BorneForce& borne = borne_[std::size_t(body)];
            b.v += (b.inv_mass * dp) * lin, b.w += dp * (b.inv_inertia * ang);
            borne.force += dp * lin, borne.torque += dp * ang;
        });
    }

    // The share k of the last step's impulses, P in all, that leaves the least energy of motion:
    //   k = -P.v / P.M^-1 P,   v: that of the forces alone.
    void begin_from_last(std::size_t first, std::size_t last)
    {
        for (Bearing& row : rows_.first(count_)) fastest_ = std::max(fastest_, std::fabs(velocity_of(row)));
        Real of_forces = 0, of_rows = 0;
        for (const Bearing& row : rows_.first(count_))
            for_bodies(row, [&](int body, Vec3 lin, Vec3 ang) {
                BorneForce& sum = borne_[std::size_t(body)];
                sum.force += row.p * lin, sum.torque += row.p * ang;
            });
        for (std::size_t i = first; i < last; ++i) {
            const SolverBody& b = kicked_[i];
            const BorneForce& P = borne_[i];
            of_forces += dot(P.force, b.v) + dot(P.torque, b.w);
            of_rows += b.inv_mass * length2(P.force) + dot(P.torque, b.inv_inertia * P.torque);
        }
        for (std::size_t i = first; i < last; ++i) borne_[i] = {};
        const Real share = of_rows > 0 ? std::min(-of_forces / of_rows, Real(1)) : 0;
        if (!(share > kLeastShare)) return;
        for (Bearing& row : rows_.first(count_)) row.dp = share * row.p, push(row, row.dp);
    }

    bool sweep()
    {
        bool any = false;
        for (Bearing& row : rows_.first(count_)) {
            const Real u = velocity_of(row);
            if (!(std::fabs(u) > kSettled * fastest_)) continue;
            const Real now = std::clamp(row.dp - u / row.d, row.lo, row.hi), change = now - row.dp;
            if (change == 0) continue;
            row.dp = now;
            push(row, change);
            any = true;
        }
        return any;
    }

    const World& world_;
    const IslandWork& work_;
    RowSystem& system_;
    const Real h_, unscale_;
    Arena& arena_;
    std::span<SolverBody> kicked_;  // v and w: h a
    std::span<BorneForce> borne_;   // J^T q until apply()
    std::span<Bearing> rows_;
    std::size_t count_ = 0;
    Real fastest_ = 0;
};

}  // namespace

std::span<const BorneForce> kick_by_prompt_forces(const World& world, IslandWork& work, Real h,
                                                  Real warm_share, Arena& arena)
{
    PromptForces forces(world, work, h, warm_share, arena);
    if (!(warm_share > 0) || !forces.any() || !forces.find()) return {};
    return forces.apply();
}

}  // namespace epode
