// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/common/stored_residual.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

// J v of a row: the sum of its terms, and of their sizes.
struct RowMotion {
    double sum = 0, size = 0;

    void add(Vec3 J, Vec3 v)
    {
        const double term = double(J.x) * double(v.x) + double(J.y) * double(v.y) + double(J.z) * double(v.z);
        sum += term, size += std::fabs(term);
    }
    void add(Vec3 lin, Vec3 ang, const SolverBody& body) { add(lin, body.v), add(ang, body.w); }
};

RowMotion motion_of(const RowSystem& system, const RowBlock& block, const Row& row,
                    std::span<const SolverBody> bodies)
{
    RowMotion motion;
    for (const WideTerm& term : terms_of(system, block))
        motion.add(term.lin, term.ang, bodies[std::size_t(term.body)]);
    if (block.term_count > 0) return motion;
    motion.add(row.lin1, row.ang1, bodies[std::size_t(block.body1)]);
    if (block.body2 >= 0) motion.add(row.lin2, row.ang2, bodies[std::size_t(block.body2)]);
    return motion;
}

double off(const RowSystem& system, const RowBlock& block, int row)
{
    const auto i = std::size_t(row);
    const RowNumbers& n = system.numbers[i];
    const double p = double(n.p), C = double(n.C), limit = std::fabs(p);
    const double d = double(inverse_effective_mass(system, block, system.rows[i], system.bodies)) + C;
    if (!(d > 0)) return 0;
    const double w = motion_of(system, block, system.rows[i], system.bodies).sum + C * p - double(n.c);
    const bool friction = n.parent >= 0;
    const double lo = friction ? -limit : double(n.lo), hi = friction ? limit : double(n.hi);
    return std::fabs(std::min(std::max(w, d * (p - hi)), d * (p - lo)));
}

double off(const RowSystem& system, const RowBlock& block)
{
    double worst = 0;
    for (int i = block.first; i < block.first + block.count; ++i)
        worst = std::max(worst, off(system, block, i));
    return worst;
}

double scale_of(const RowSystem& system, std::span<const SolverBody> v_star)
{
    double scale = 0;
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const RowMotion before = motion_of(system, block, system.rows[std::size_t(i)], v_star);
            const double change = double(system.numbers[std::size_t(i)].c) - before.sum;
            scale = std::max({scale, std::fabs(change), 1e-3 * before.size});
        }
    return scale > 0 ? scale : 1;
}

}  // namespace

StoredResidual stored_residual(const RowSystem& system, std::span<const SolverBody> v_star)
{
    StoredResidual out;
    const double scale = scale_of(system, v_star);
    for (std::size_t k = 0; k < system.blocks.size(); ++k) {
        const RowBlock& block = system.blocks[k];
        const double r = off(system, block) / scale;
        const bool unsolved = r > kUnsolved && !block.contact;
        if (r > out.worst) out.worst_joint = unsolved ? int(k) : -1;
        out.worst = std::max(out.worst, r);
        out.unsolved_joints += unsolved;
    }
    return out;
}

}  // namespace epode
