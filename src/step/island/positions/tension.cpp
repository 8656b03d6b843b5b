// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A joint force F on a lever r turns with the pose: swinging the lever by a small angle t costs F.r |t|^2/2,
// a geometric stiffness. A light link in a chain that carries a heavy load is a pendulum of frequency sqrt(F
// r/I), which a step that holds the directions of forces fixed, as ODE's does, cannot follow once h^2 F r >
// I: it then swings through its rest position to amplitudes that only the kinetic energy of the load bounds,
// and tears the joints open. There, such a frequency cannot be resolved by any h of this size, so that the
// inertia may be raised to where it can:
//
//   S = sum over the body's joints of h |P| |r| (1 - n n^T),  P = h F, n = P/|P|
//   I' = I + max(0, 1 - k/q) S,   of links: bodies that two joints load or more
//   q = the largest of  s/I_max, s = tr S / 2,  and of the eigenvalues of  I^-1 sum h |P.r| (1 - r r^T/r^2)
//
// The eigenvalues find links that are easily turned in one direction only: a plank of a bridge about its hinge. Turns about the lever
// itself, as easy in a thin rod, move no joint.
//
// k = 3: at 4 the frequency reaches 2/h, and steps that hold directions become unstable; sweeps that leave
// joints unsolved are unstable from k = 1 on. Ten equal links that swing free do not reach 3 in steps of 10 ms.
//
// Links that are raised and joined also lose the share k/2 of what their spin differs from that of their raised
// neighbours: what they toss to and fro would else reach the load with the raised inertia, many times over.
//
// Turns about the load's own line stay as they were, and so does every body whose swinging is resolved. The
// load itself and the links' masses are untouched: the slow motion is the same.
//
// Source: the geometric stiffness of constraints: Tournier, Nesme, Gilles & Faure, "Stable Constrained
// Dynamics", ACM Trans. Graph. 34 (2015); mass scaling is common in explicit finite elements (Olovsson et
// al., 2005). The margin is narrow: links raised twice as far carry enough spin to throw the load. Rejected: S as a stiffness, M + h S with
// damped velocities, which takes four times the energy from a swinging chain; spins as large as the momentum
// that they had, which tears as many; and position correction alone, whose Newton steps do not converge on
// such poses.
#include "step/island/positions/tension.h"

#include <algorithm>
#include <cmath>

#include "math/cholesky.h"
#include "step/island/problem/joint_memory.h"

namespace epode {
namespace {

// Times the largest moment: more would leave no digits to the turns about the load's line.
constexpr Real kMaxRaise = kSingle ? Real(1e3) : Real(1e10);

// What a joint exerted, its levers, squared, and these themselves, 0 where they are not known.
struct Load {
    Vec3 P;
    Real r1, r2;
    Vec3 arm1, arm2;
};

Load load_of(const Joint& joint, const RowBlock& block, const RowSystem& system)
{
    const Real* p = impulses(joint);
    if (block.point || block.form == RowForm::kPoint)
        return {
            {p[0], p[1], p[2]}, length2(block.arms.r1), length2(block.arms.r2), block.arms.r1, block.arms.r2};
    Load load{};
    int directions = 0;
    for (int i = 0; i < block.count; ++i) {
        const Row& row = system.rows[std::size_t(block.first + i)];
        if (row.lin1 == Vec3{}) continue;
        load.P += p[i] * row.lin1;
        load.r1 = std::max(load.r1, length2(row.ang1));
        load.r2 = std::max(load.r2, length2(row.ang2));
        ++directions;
        load.arm1 += Real(0.5) * cross(row.lin1, row.ang1),
            load.arm2 += Real(0.5) * cross(row.lin2, row.ang2);
    }
    if (directions != 3) load.arm1 = load.arm2 = {};
    return load;
}

// s += k (1 - a a^T / |a|^2)
void add_swing(Sym3& s, Vec3 a, Real k)
{
    const Real size = length(a);
    if (!(size > 0)) return;
    const Vec3 n = a / size;
    s.xx += k * (1 - n.x * n.x), s.yy += k * (1 - n.y * n.y), s.zz += k * (1 - n.z * n.z);
    s.xy -= k * n.x * n.y, s.xz -= k * n.x * n.z, s.yz -= k * n.y * n.z;
}

Real trace(const Sym3& s) { return s.xx + s.yy + s.zz; }

// tr A B
Real trace(const Sym3& a, const Sym3& b)
{
    return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

// The largest eigenvalue of A B, two matrices without negative ones, if the least is 0, else a bound of it: from the sum of the
// eigenvalues and that of their squares.
Real largest_eigenvalue(const Sym3& a, const Sym3& b)
{
    const Real sum = trace(a, b);
    const Mat3 product = full(a) * full(b);
    const Real squares = dot(product.row0, {product.row0.x, product.row1.x, product.row2.x}) +
                         dot(product.row1, {product.row0.y, product.row1.y, product.row2.y}) +
                         dot(product.row2, {product.row0.z, product.row1.z, product.row2.z});
    return (sum + std::sqrt(std::max(Real(0), 2 * squares - sum * sum))) / 2;
}

// Returns the share k of S that the body's inertia has been raised by, 0: none.
Real raise(const Body& body, SolverBody& out, const Swing& swing, Real resolved)
{
    const Sym3& S = swing.S;
    const Real s = trace(S) / 2;
    if (!(out.inv_mass > 0) || !usable(s)) return 0;
    const bool easily = trace(out.inv_inertia, swing.at_arms) > resolved;
    if (!easily && !(3 * s > trace(body.inertia))) return 0;
    Sym3 I = rotate(body.rotation(), body.inertia);
    const Real largest = std::max(I.xx, std::max(I.yy, I.zz));
    Real q = s / largest;
    if (easily) q = std::max(q, largest_eigenvalue(out.inv_inertia, swing.at_arms));
    if (!(q > resolved)) return 0;
    const Real k = std::min(1 - resolved / q, kMaxRaise * largest / s);
    I.xx += k * S.xx, I.yy += k * S.yy, I.zz += k * S.zz;
    I.xy += k * S.xy, I.xz += k * S.xz, I.yz += k * S.yz;
    Mat3 inverse;
    if (!invert(full(I), inverse)) return 0;
    const Sym3 inv_inertia = symmetric_part(inverse);
    if (!positive_definite(inv_inertia)) return 0;
    out.inertia = I, out.inv_inertia = inv_inertia;
    return k;
}

// Sums S of the bodies, which are made when the first joint needs them.
class Swings {
  public:
    Swings(const IslandWork& work, Real h, Real resolved, Arena& arena)
        : work_(work), h_(h), least_(resolved / 2), arena_(arena)
    {}

    void add(int body, Vec3 P, Real arm2, Vec3 arm)
    {
        if (body < 0) return;
        const auto at = std::size_t(body);
        const Sym3& inverse = work_.system.bodies[at].inv_inertia;
        const Real moment2 = h_ * h_ * length2(P) * arm2, all = trace(inverse);
        if (!(moment2 * all * all > least_ * least_)) return;
        const Real turning = h_ * std::fabs(dot(P, arm));
        const bool easily = turning * (all * arm2 - dot(arm, inverse * arm)) > least_ * arm2;
        if (easily || matters(*work_.island.bodies[at], moment2))
            add(at, P, moment2, arm, easily ? turning : 0);
    }
    std::span<const Swing> sums() const { return S_; }

  private:
    // A quarter of what would raise the inertia, by the largest moment.
    static bool matters(const Body& body, Real moment2)
    {
        const Real quarter = trace(body.inertia) / 12;
        return moment2 > quarter * quarter;
    }

    void add(std::size_t body, Vec3 P, Real moment2, Vec3 arm, Real turning)
    {
        if (S_.empty()) S_ = arena_.take_zeroed<Swing>(int(work_.system.bodies.size()));
        if (S_.empty()) return;
        Swing& swing = S_[body];
        add_swing(swing.S, P, std::sqrt(moment2)), ++swing.loads;
        if (turning > 0) add_swing(swing.at_arms, arm, turning);
    }

    const IslandWork& work_;
    const Real h_;
    const Real least_;  // half of what raises an inertia, at right angles to the arm: of one of two joints
    Arena& arena_;
    std::span<Swing> S_;
};

// A body that is raised, and what is around it.
struct Raised {
    Real k;    // 0: it is not
    Vec3 sum;  // of the spins of raised bodies joined to it
    int count;
};

void calm(const IslandWork& work, std::span<SolverBody> bodies, std::span<Raised> raised)
{
    for (std::size_t i = 0; i < work.joints.size(); ++i) {
        const RowBlock& block = work.system.blocks[i];
        if (block.contact || block.body2 < 0) continue;
        const auto a = std::size_t(block.body1), b = std::size_t(block.body2);
        if (!(raised[a].k > 0) || !(raised[b].k > 0)) continue;
        raised[a].sum += bodies[b].w, ++raised[a].count;
        raised[b].sum += bodies[a].w, ++raised[b].count;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (const Raised& r = raised[i]; r.count > 0)
            bodies[i].w += Real(0.5) * r.k * (r.sum / Real(r.count) - bodies[i].w);
}

}  // namespace

std::span<const Swing> find_swings(const IslandWork& work, Real h, Real resolved, Arena& arena)
{
    Swings swings(work, h, resolved, arena);
    for (std::size_t k = 0; k < work.joints.size(); ++k) {
        const RowBlock& block = work.system.blocks[k];
        const Joint& joint = *work.joints[k];
        if (block.contact || joint.impulse_rows != block.count) continue;
        Load load = load_of(joint, block, work.system);
        load.P *= step_ratio(lasting(joint), work.system.h);
        swings.add(block.body1, load.P, load.r1, load.arm1);
        swings.add(block.body2, load.P, load.r2, load.arm2);
    }
    return swings.sums();
}

int add_tension(const IslandWork& work, std::span<SolverBody> bodies, Real h, Real resolved, Arena& arena,
                std::span<bool> marks)
{
    Arena::Scope scope(arena);
    const std::span<const Swing> swings = find_swings(work, h, resolved, arena);
    if (swings.empty()) return 0;
    const std::span<Raised> raised = arena.take_zeroed<Raised>(int(bodies.size()));
    if (raised.empty()) return 0;
    int count = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Swing& swing = swings[i];
        raised[i].k = swing.is_link() ? raise(*work.island.bodies[i], bodies[i], swing, resolved) : 0;
        if (!(raised[i].k > 0)) continue;
        ++count;
        if (!marks.empty()) marks[i] = true;
    }
    if (count > 0) calm(work, bodies, raised);
    return count;
}

}  // namespace epode
