// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What an impact changes: the velocities of bodies, row by row. Body 2 below zero is the world.
#pragma once

#include "rows/row_system.h"

namespace epode {

struct ImpactBodies {
    std::span<SolverBody> bodies;

    const SolverBody* at(int body) const { return body >= 0 ? &bodies[std::size_t(body)] : nullptr; }

    // J v.
    Real velocity(const Jacobian& J, int body1, int body2) const
    {
        const SolverBody& a = bodies[std::size_t(body1)];
        const Real w = dot(J.lin1, a.v) + dot(J.ang1, a.w);
        if (body2 < 0) return w;
        const SolverBody& b = bodies[std::size_t(body2)];
        return w + (dot(J.lin2, b.v) + dot(J.ang2, b.w));
    }

    // J M^-1 K^T.
    Real freedom(const Jacobian& J, const Jacobian& K, int body1, int body2) const
    {
        return freedom(J.lin1, J.ang1, K.lin1, K.ang1, at(body1)) +
               freedom(J.lin2, J.ang2, K.lin2, K.ang2, at(body2));
    }

    void push(const Jacobian& J, int body1, int body2, Real p) const
    {
        push(bodies[std::size_t(body1)], p, J.lin1, J.ang1);
        if (body2 >= 0) push(bodies[std::size_t(body2)], p, J.lin2, J.ang2);
    }

  private:
    static Real freedom(Vec3 lin, Vec3 ang, Vec3 lin_k, Vec3 ang_k, const SolverBody* b)
    {
        return b ? b->inv_mass * dot(lin, lin_k) + dot(ang, b->inv_inertia * ang_k) : 0;
    }

    static void push(SolverBody& b, Real p, Vec3 lin, Vec3 ang)
    {
        b.v += (b.inv_mass * p) * lin;
        b.w += p * (b.inv_inertia * ang);
    }
};

}  // namespace epode
