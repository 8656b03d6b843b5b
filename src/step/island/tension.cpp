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
//   I' = I + max(0, 1 - I_max/s) S,  s = tr S / 2
//
// Turns about the load's own line stay as they were, and so does every body whose swinging is resolved. The
// load itself and the links' masses are untouched: the slow motion is the same.
//
// Source: the geometric stiffness of constraints: Tournier, Nesme, Gilles & Faure, "Stable Constrained
// Dynamics", ACM Trans. Graph. 34 (2015); mass scaling is common in explicit finite elements (Olovsson et
// al., 2005). Rejected: S as a stiffness, M + h S with damped velocities, which takes four times the energy
// from a swinging chain; and position correction alone, whose Newton steps do not converge on such poses.
#include "step/island/tension.h"

#include <algorithm>

namespace epode {
namespace {

struct Load {
    Vec3 P;       // impulse of the joint
    Real r1, r2;  // levers
};

Load load_of(const Joint& joint, const RowBlock& block, const RowSystem& system)
{
    Load load{{}, 0, 0};
    for (int i = 0; i < block.count; ++i) {
        const Row& row = system.rows[std::size_t(block.first + i)];
        if (row.lin1 == Vec3{}) continue;
        load.P += impulses(joint)[i] * row.lin1;
        load.r1 = std::max(load.r1, length(row.ang1));
        load.r2 = std::max(load.r2, length(row.ang2));
    }
    return load;
}

// s += k (|P| 1 - P P^T / |P|)
void add_swing(Sym3& s, Vec3 P, Real k)
{
    const Real size = length(P);
    if (!(size > 0)) return;
    const Vec3 n = P / size;
    k *= size;
    s.xx += k * (1 - n.x * n.x), s.yy += k * (1 - n.y * n.y), s.zz += k * (1 - n.z * n.z);
    s.xy -= k * n.x * n.y, s.xz -= k * n.x * n.z, s.yz -= k * n.y * n.z;
}

void raise(SolverBody& body, const Sym3& S)
{
    if (!(body.inv_mass > 0)) return;
    Sym3 I = body.inertia;
    const Real s = (S.xx + S.yy + S.zz) / 2, largest = std::max(I.xx, std::max(I.yy, I.zz));
    if (!(s > largest) || !usable(s)) return;
    const Real k = 1 - largest / s;
    I.xx += k * S.xx, I.yy += k * S.yy, I.zz += k * S.zz;
    I.xy += k * S.xy, I.xz += k * S.xz, I.yz += k * S.yz;
    Mat3 inverse;
    if (!invert(full(I), inverse)) return;
    body.inertia = I;
    body.inv_inertia = symmetric_part(inverse);
}

}  // namespace

void add_tension(const IslandWork& work, std::span<SolverBody> bodies, Arena& arena)
{
    Arena::Scope scope(arena);
    auto S = arena.take_zeroed<Sym3>(int(bodies.size()));
    if (S.empty()) return;
    bool any = false;
    for (std::size_t k = 0; k < work.joints.size(); ++k) {
        const RowBlock& block = work.system.blocks[k];
        const Joint& joint = *work.joints[k];
        if (block.contact || joint.impulse_rows != block.count) continue;
        const Load load = load_of(joint, block, work.system);
        add_swing(S[std::size_t(block.body1)], load.P, work.system.h * load.r1);
        if (block.body2 >= 0) add_swing(S[std::size_t(block.body2)], load.P, work.system.h * load.r2);
        any = true;
    }
    for (std::size_t i = 0; any && i < bodies.size(); ++i) raise(bodies[i], S[i]);
}

}  // namespace epode
