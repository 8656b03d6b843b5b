// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Weighted sums of coordinates, s = sum f q: couplings hold one where it is, tendons pull on one with springs, dampers and servos, and
// have limits. A coupling that is bent holds s - p(x), p the higher powers of another sum x, by its tangent at the present position. Their dofs may stand on different chains, which a spring would join in the mass matrix; so what depends on s is a row,
//     F = F0 - (d + h k) ds/dt+,  J v + impulse / (h (d + h k)) = F0 / (d + h k),
// and what does not is a torque on each dof.
#pragma once

#include "batch/lanes/drives.h"
#include "batch/lanes/loops.h"
#include "batch/lanes/singles.h"

namespace epode::batch {
namespace {

template <typename P, bool own>
struct Sums {
    using T = typename P::Number;
    const ModelView& model;
    Numbers<P, own> numbers;
    const StepOptions& options;
    const P *q, *v, *forces;
    Work<P>& work;

    void find() const
    {
        for (int i = 0; i < model.sums.size(); ++i) {
            work.sum_ready[i] = false;
            const BatchSum& sum = model.sums[i];
            if (sum.stop >= 0) stop(sum, i);
            if (sum.drive >= 0) drive(sum, work.sums[i].drive);
        }
    }

    // y of the sum, on all ancestors of its dofs.
    Direction<P> along(const BatchSum& sum) const
    {
        P* y = work.sum_y + sum.support;
        const int* dofs = model.sum_dofs.first + sum.support;
        const int number = int(&sum - model.sums.first);
        P* shares = sum.places < 0 ? nullptr : work.shares + model.loop_rows * (model.velocities + number);
        const Direction<P> out{y, work.sum_z + sum.support, sum.width, shares};
        if (work.sum_ready[number]) return out;
        work.sum_ready[number] = true;
        P* x = work.scattered;
        for (int k = 0; k < sum.width; ++k) x[dofs[k]] = P(0);
        for (int k = sum.first_term; k < sum.first_term + sum.terms; ++k) {
            const SumTerm& term = model.sum_terms[k];
            x[term.dof] = x[term.dof] + numbers[term.factor];
        }
        if (sum.curve >= 0) bend(sum, work.sums[number].slope, x);
        carry(sum, x);
        for (int k = 0; k < sum.width; ++k) y[k] = work.root[dofs[k]] * x[dofs[k]];
        if (shares)
            Loops<P, own>{model, numbers, options, q, work}.project(y, model.places.first + sum.places,
                                                                    shares);
        return out;
    }

    // The polynomial's part of J, at the present position.
    void bend(const BatchSum& sum, const P& slope, P* x) const
    {
        for (int k = sum.first_inner; k < sum.first_inner + sum.inner; ++k) {
            const SumTerm& term = model.sum_terms[k];
            x[term.dof] = x[term.dof] - slope * numbers[term.factor];
        }
    }

    // x = L^-T x, on those dofs: all ancestors of each are among them.
    void carry(const BatchSum& sum, P* x) const
    {
        const int* dofs = model.sum_dofs.first + sum.support;
        for (int k = sum.width; k-- > 0;) {
            const Dof& dof = model.dofs[dofs[k]];
            const int* chain = model.chains.first + dof.chain;
            const P* row = work.m + dof.row;
            for (int l = 0; l < dof.depth; ++l) x[chain[l]] = x[chain[l]] - row[l] * x[dofs[k]];
        }
    }

    Singles<P> singles() const { return {options, forces, work}; }

    // An equality takes its error back from both sides; a limit, the nearer of the two, lets go.
    void stop(const BatchSum& sum, int i) const
    {
        const int at = model.first_sum() + sum.stop;
        const P zero(0), one(1), far(T(1e30)), low = numbers[sum.first + sum_number::kLow],
                                               length = work.sums[i].length;
        if (sum.is_equality) {
            const P most(T(options.most_correction)), error = length - low;
            const Law<P> law{clip(P(T(-options.erp / options.h)) * error, -most, most), zero};
            SingleRow<P>& row = singles().add(along(sum), at, one, one, law);
            row.low = -far, row.high = far;
            return singles().begin(row, at);
        }
        const P below = length - low, above = numbers[sum.first + sum_number::kHigh] - length;
        const P sign = nearer_end(sum, length), gap = at_most(below, above);
        const P reach = P(T(kNearStop)) + P(T(2 * options.h)) * magnitude(rate(sum));
        const P near = if_greater(reach, gap, one, zero);
        work.impulses[at] = zero;
        if (!any_positive(near)) return;
        SingleRow<P>& row = singles().add(along(sum), at, sign, near, law_of(gap, zero, zero, options));
        row.low = zero, row.high = if_positive(near, far, zero);
        singles().begin(row, at);
    }

    // -1: the upper one, whose limit pushes back.
    P nearer_end(const BatchSum& sum, const P& length) const
    {
        const P below = length - numbers[sum.first + sum_number::kLow],
                above = numbers[sum.first + sum_number::kHigh] - length;
        return if_greater(below, above, P(-1), P(1));
    }

    P rate(const BatchSum& sum) const
    {
        P out(0);
        for (int k = sum.first_term; k < sum.first_term + sum.terms; ++k)
            out = out + numbers[model.sum_terms[k].factor] * v[model.sum_terms[k].dof];
        return out;
    }

    void drive(const BatchSum& sum, const ServoWork<P>& its) const
    {
        const int at = model.first_sum() + sum.drive;
        const P h(T(options.h)), gain = inverse_or_zero(its.gain);
        const P most = h * numbers[sum.first + sum_number::kForceLimit];
        SingleRow<P>& row = singles().add(along(sum), at, P(1), its.gain, {its.force * gain, gain / h});
        row.low = -most, row.high = most;
        singles().begin(row, at);
    }

    static constexpr double kNearStop = 0.01;  // of the sum's unit
};

}  // namespace
}  // namespace epode::batch
