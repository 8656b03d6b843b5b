// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/tree/tree_factor.h"

#include <algorithm>
#include <cmath>

namespace epode {

bool TreeFactor::prepare(const JointTree& tree, Arena& arena)
{
    const int n = tree.dofs();
    start_ = arena.take<int>(n), depth_ = arena.take<int>(n), up_ = arena.take<int>(n);
    root_ = arena.take<double>(n), composites_ = arena.take<Composite>(int(tree.links().size()));
    if (arena.failed()) return false;
    int count = 0;
    for (int k = 0; k < n; ++k) {
        const auto at = std::size_t(k);
        start_[at] = count, depth_[at] = tree.depth(k), up_[at] = tree.up(k);
        count += depth_[at] + 1;
    }
    values_ = arena.take<double>(count);
    return !arena.failed();
}

// With d from O: I_O = I + m (|d|^2 1 - d d^T).
TreeFactor::Composite TreeFactor::about_O(Real mass, const Sym3& I, Vec3 d)
{
    const Vec3 md = mass * d;
    const Real xx = md.x * d.x, yy = md.y * d.y, zz = md.z * d.z;
    return {mass,
            md,
            {I.xx + (yy + zz), I.yy + (xx + zz), I.zz + (xx + yy), I.xy - md.x * d.y, I.xz - md.x * d.z,
             I.yz - md.y * d.z}};
}

void TreeFactor::project(const JointTree& tree)
{
    const std::span<const TreeLink> links = tree.links();
    for (std::size_t i = links.size(); i-- > 0;) {
        const TreeLink& link = links[i];
        const Composite& c = composites_[i];
        for (int k = link.first; k < link.first + link.count; ++k) {
            const Spatial& m = tree.motion(k);
            const Spatial f{c.inertia * m.ang + cross(c.moment, m.lin),
                            c.mass * m.lin + cross(m.ang, c.moment)};
            double* const row = &values_[std::size_t(start_[std::size_t(k)])];
            for (int j = k, d = depth_[std::size_t(k)]; j >= 0; j = up_[std::size_t(j)], --d)
                row[d] = double(dot(tree.motion(j), f));
        }
        if (link.parent < 0) continue;
        Composite& to = composites_[std::size_t(link.parent)];
        const Sym3 &s = to.inertia, &t = c.inertia;
        to = {to.mass + c.mass,
              to.moment + c.moment,
              {s.xx + t.xx, s.yy + t.yy, s.zz + t.zz, s.xy + t.xy, s.xz + t.xz, s.yz + t.yz}};
    }
}

void TreeFactor::factor()
{
    for (std::size_t k = start_.size(); k-- > 0;) {
        double* const row = &values_[std::size_t(start_[k])];
        const int depth = depth_[k];
        const double inverse = 1 / row[depth];
        int i = up_[k];
        for (int d = depth - 1; d >= 0; --d, i = up_[std::size_t(i)]) {
            double* const its = &values_[std::size_t(start_[std::size_t(i)])];
            const double a = row[d] * inverse;
            for (int e = 0; e <= d; ++e) its[e] -= a * row[e];
            row[d] = a;
        }
        root_[k] = std::sqrt(inverse);
    }
}

void TreeFactor::to_factor_space(std::span<double> x) const
{
    for (std::size_t k = x.size(); k-- > 0;) {
        const double its = x[k];
        if (its == 0) continue;
        const double* const row = &values_[std::size_t(start_[k])];
        int i = up_[k];
        for (int d = depth_[k] - 1; d >= 0; --d, i = up_[std::size_t(i)]) x[std::size_t(i)] -= row[d] * its;
        x[k] = its * root_[k];
    }
}

void TreeFactor::to_velocities(std::span<double> z) const
{
    for (std::size_t k = 0; k < z.size(); ++k) {
        const double* const row = &values_[std::size_t(start_[k])];
        double sum = z[k] * root_[k];
        int i = up_[k];
        for (int d = depth_[k] - 1; d >= 0; --d, i = up_[std::size_t(i)]) sum -= row[d] * z[std::size_t(i)];
        z[k] = sum;
    }
}

}  // namespace epode
