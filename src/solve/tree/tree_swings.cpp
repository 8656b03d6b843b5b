// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How fast the swinging of light links is in joint coordinates: eigenvalues of H^-1 T^T S T.
#include "solve/tree/tree_solve.h"

#include <cmath>

namespace epode {

// With spins of links w = W z, the sum of traces of W^T S W.
double TreeSolve::trace_of(std::span<const Sym3> swings)
{
    double sum = 0;
    for (std::size_t i = 0; i < swings.size(); ++i) {
        const Sym3& S = swings[i];
        if (S.xx + S.yy + S.zz == 0) continue;
        double G[3][3];  // W W^T of the link
        for (int k = 0; k < 3; ++k) {
            Vec3 unit;
            unit.set(k, 1);
            const std::span<double> to = spins_[std::size_t(k)];
            std::fill(to.begin(), to.end(), 0);
            add_chain(int(i), on_body(int(i), {}, unit), to);
            factor_.to_factor_space(to);
            for (int l = 0; l <= k; ++l)
                G[k][l] = product(to.data(), spins_[std::size_t(l)].data(), to.size());
        }
        sum += double(S.xx) * G[0][0] + double(S.yy) * G[1][1] + double(S.zz) * G[2][2] +
               2 * (double(S.xy) * G[1][0] + double(S.xz) * G[2][0] + double(S.yz) * G[2][1]);
    }
    return sum;
}

// By powers, from below.
double TreeSolve::largest_of(std::span<const Sym3> swings)
{
    constexpr int kPowers = 10;
    const std::span<double> x = spins_[0];
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = k % 2 == 0 ? 1 : 0.5;
    double size = std::sqrt(product(x.data(), x.data(), x.size())), largest = 0;
    for (int power = 0; power < kPowers && size > 0; ++power) {
        for (double& each : x) each /= size;
        factor_.to_velocities(x);
        tree_->velocities(x, scratch_);
        for (std::size_t i = 0; i < scratch_.size(); ++i) scratch_[i] = {swings[i] * scratch_[i].ang, {}};
        tree_->gather(scratch_, x);
        factor_.to_factor_space(x);
        size = largest = std::sqrt(product(x.data(), x.data(), x.size()));
    }
    return largest;
}

bool TreeSolve::resolves(std::span<const Sym3> swings, double largest)
{
    return trace_of(swings) <= largest || largest_of(swings) <= largest;
}

}  // namespace epode
