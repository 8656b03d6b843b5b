// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One island as a solver sees it: bodies, rows and numbers, no joints and no world. With impulses p = h
// lambda
//
//   M (v - v*) = J^T p,     w_i = J_i v + C_i p_i - c_i
//   lo_i < p_i < hi_i -> w_i = 0;   p_i = lo_i -> w_i >= 0;   p_i = hi_i -> w_i <= 0
//
// where v* is the velocity after all external forces, C = cfm/h, and friction rows take their bounds from
// their parent's impulse. A solver leaves p and v; the caller need not know which solver it was.
#pragma once

#include <span>

#include "math/pose.h"
#include "rows/contact_manifold.h"
#include "rows/joint_manifold.h"
#include "rows/row.h"

namespace epode {

// 128 bytes in double: what sweeps touch comes first.
struct SolverBody {
    Vec3 v, w;          // in: v*; out: the answer
    Real inv_mass = 0;  // zero for kinematic bodies
    Sym3 inv_inertia;   // world frame
    Real mass = 0;      // of the exact solver; 0 when inv_mass is 0
    Sym3 inertia;       // world frame
};

// The pose of a body within a step in substeps, with its mass and inertia there, in groups of four numbers as
// lanes read them.
struct alignas(4 * sizeof(Real)) SolverPose {
    Vec3 x;
    Real inv_mass = 0;
    Quat q;
    Vec3 main;  // of the inverse inertia, world frame: xx, yy, zz
    Real unused1 = 0;
    Vec3 mixed;  // xy, xz, yz
    Real unused2 = 0;
};
static_assert(sizeof(SolverPose) == 16 * sizeof(Real));

struct BlockWrench;       // rows/wrench.h
struct Velocity;          // solve/common/velocities.h
struct ManifoldFriction;  // solve/common/manifold_friction.h

// The numbers that a policy derives from a Row.
struct RowNumbers {
    Real c = 0;       // target J v, m/s or rad/s
    Real C = 0;       // compliance of p: cfm / h
    Real lo = -kInf;  // bounds of p; for rows with a parent: hi is the friction coefficient, lo = -hi
    Real hi = kInf;
    Real p = 0;       // impulse: warm start in, answer out
    int parent = -1;  // row of the island, or -1
    bool bounded() const { return lo > -kInf || hi < kInf; }
};

// The rows of one joint.
struct RowBlock {
    int first = 0;
    int count = 0;
    int body1 = 0;         // index into bodies
    int body2 = -1;        // below zero: the world of part -1 - body2 of the system
    bool contact = false;  // rows of one contact point with these arms: normal, tangents, then rolling rows
    ContactArms arms;
    RowForm form = RowForm::kFree;  // of a joint's rows
    bool point = false;             // its rows at this pose have the form kPoint, whatever `form` is
    bool followed = false;          // by a solver with substeps that keeps the rows up to date itself
    // Of a coupling: the one Jacobian of all its rows, over more than two bodies, in place of theirs and of
    // body1 and body2. Its rows are called wide.
    int first_term = 0, term_count = 0;
    int wrench = -1;    // in RowSystem::wrenches; -1: only the impulses of its rows are wanted
    bool cone = false;  // of a contact for sweeps: friction is bounded by an ellipse, not a box
    bool coulomb =
        false;  // of a contact for exact solvers: friction is bounded by its present normal impulse, in an ellipse
};

// The part of a wide row's Jacobian that belongs to one body of the island.
struct WideTerm {
    int body;
    Vec3 lin, ang;
};

// Islands that are solved together, because each alone would leave most lanes empty, are parts of one system
// and share nothing. They do not even share the world, so that a NaN in one of them stays there. Each part
// ends before these.
struct SystemPart {
    int bodies = 0, blocks = 0, joint_manifolds = 0, contact_manifolds = 0;
};

struct RowSystem {
    Real h = 0;
    bool coulomb = false;            // some blocks are
    bool nearly_solved = false;      // p is the answer of a nearby problem: rows on bounds begin there
    bool manifold_friction = false;  // a manifold has one friction for all their points
    std::span<SolverBody> bodies;
    std::span<Row> rows;
    std::span<RowNumbers> numbers;     // parallel to rows
    std::span<RowBlock> blocks;        // in joint order, covering rows without gaps
    std::span<WideTerm> terms;         // of the blocks of couplings
    JointManifoldList joint_contacts;  // for solvers that take them, else empty; not among the rows
    std::span<ContactManifold* const> contact_manifolds;  // likewise
    std::span<const SystemPart> parts;                    // none: all is one
    std::span<const ManifoldFriction> frictions;  // of the solution: one friction for several points each
    std::span<SolverPose> poses;      // with substeps and blocks: of the bodies, then of the worlds
    std::span<BlockWrench> wrenches;  // with substeps: what blocks have exerted, a sum over the substeps

    int worlds() const { return parts.empty() ? 1 : int(parts.size()); }
    SystemPart begin_of(int part) const { return part > 0 ? parts[std::size_t(part - 1)] : SystemPart{}; }
    SystemPart end_of(int part) const
    {
        if (!parts.empty()) return parts[std::size_t(part)];
        return {int(bodies.size()), int(blocks.size()), int(joint_contacts.manifolds.size()),
                int(contact_manifolds.size())};
    }
};

inline std::span<WideTerm> terms_of(const RowSystem& system, const RowBlock& block)
{
    return system.terms.subspan(std::size_t(block.first_term), std::size_t(block.term_count));
}

// J_i v of row r between bodies a and b (null: world).
inline Real row_velocity(const Row& r, const SolverBody& a, const SolverBody* b)
{
    Real s = dot(r.lin1, a.v) + dot(r.ang1, a.w);
    if (b) s += dot(r.lin2, b->v) + dot(r.ang2, b->w);
    return s;
}

// v += M^-1 J^T dp
inline void apply_impulse(const Row& r, Real dp, SolverBody& a, SolverBody* b)
{
    a.v += (a.inv_mass * dp) * r.lin1;
    a.w += dp * (a.inv_inertia * r.ang1);
    if (b) {
        b->v += (b->inv_mass * dp) * r.lin2;
        b->w += dp * (b->inv_inertia * r.ang2);
    }
}

// The inverse effective mass J M^-1 J^T of one row, without C.
inline Real inverse_effective_mass(const Row& r, const SolverBody& a, const SolverBody* b)
{
    Real s = a.inv_mass * length2(r.lin1) + dot(r.ang1, a.inv_inertia * r.ang1);
    if (b) s += b->inv_mass * length2(r.lin2) + dot(r.ang2, b->inv_inertia * r.ang2);
    return s;
}

// The same for a row of a block, which may be wide, among these bodies of the system.
inline Real row_velocity(const RowSystem& system, const RowBlock& block, const Row& r,
                         std::span<const SolverBody> bodies)
{
    if (block.term_count == 0)
        return row_velocity(r, bodies[std::size_t(block.body1)],
                            block.body2 < 0 ? nullptr : &bodies[std::size_t(block.body2)]);
    Real s = 0;
    for (const WideTerm& term : terms_of(system, block)) {
        const SolverBody& body = bodies[std::size_t(term.body)];
        s += dot(term.lin, body.v) + dot(term.ang, body.w);
    }
    return s;
}

inline void apply_impulse(const RowSystem& system, const RowBlock& block, const Row& r, Real dp,
                          std::span<SolverBody> bodies)
{
    if (block.term_count == 0)
        return apply_impulse(r, dp, bodies[std::size_t(block.body1)],
                             block.body2 < 0 ? nullptr : &bodies[std::size_t(block.body2)]);
    for (const WideTerm& term : terms_of(system, block)) {
        SolverBody& body = bodies[std::size_t(term.body)];
        body.v += (body.inv_mass * dp) * term.lin;
        body.w += dp * (body.inv_inertia * term.ang);
    }
}

inline Real inverse_effective_mass(const RowSystem& system, const RowBlock& block, const Row& r,
                                   std::span<const SolverBody> bodies)
{
    if (block.term_count == 0)
        return inverse_effective_mass(r, bodies[std::size_t(block.body1)],
                                      block.body2 < 0 ? nullptr : &bodies[std::size_t(block.body2)]);
    Real s = 0;
    for (const WideTerm& term : terms_of(system, block)) {
        const SolverBody& body = bodies[std::size_t(term.body)];
        s += body.inv_mass * length2(term.lin) + dot(term.ang, body.inv_inertia * term.ang);
    }
    return s;
}

}  // namespace epode
