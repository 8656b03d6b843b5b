// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Derivatives of a step by the implicit function theorem at its solution. With the impulses p kept, the step without its solve is a
// smooth function of state, controls and numbers x,
//     z(x) = z*(x) + Y(x) p,     v+ = L^-1 D^-1/2 z,
// and so is the error of each row that acts (the active set):
//     normals, singles    e = sign y.z - bias + soft p
//     tangents that stick e = y.z
//     tangents that slide e = p_t + mu p_n (t + bend (y.z - u0)),     t = u0 / |u0|,  bend = (1 - t t') / |u0|:
//                         Coulomb's cone p_t = -mu p_n u / |u|, linear about the solution.
// e = 0 stays true along a change of x, so with E = de/dp (active_set.h) and M^-1 J' = L^-1 D^-1/2 Y the derivative is
//     dv+/dx = d(v+ | p)/dx - K de/dx,     K = M^-1 J' E^-1.
// Both derivatives of smooth functions on the right are differences between two groups of copies that stand apart, a column each lane;
// nothing is solved in them.
#pragma once

#include "batch/lanes/active.h"
#include "batch/lanes/tangent.h"

namespace epode::batch {
namespace {

template <typename P, bool own>
struct Sensitivity {
    using T = typename P::Number;
    const ModelView& model;
    const StepOptions& options;
    Work<P>& work;

    GroupLayout layout() const { return GroupLayout(model); }
    Step<P, own> step(const T* numbers) const { return {model, options, {numbers}, work}; }
    int impulse_of(const P* impulse) const { return int(impulse - work.impulses); }

    void move(const Apart<T>& pair, T* group, T sign) const
    {
        const GroupLayout at = layout();
        move_state(model, rows_at<P>(const_cast<T*>(pair.seed), 0), P(sign), rows_at<P>(group, at.q),
                   rows_at<P>(group, at.v), work.v);
    }

    // Each lane's column of d(next)/dx. Where a copy goes bad: not a number.
    void find(const Apart<T>& pair, const ActiveSet<T>* active) const
    {
        move(pair, pair.plus, T(1)), move(pair, pair.minus, T(-1));
        if (active)
            follow(pair, *active);
        else
            step(pair.numbers_plus).take(pair.plus), step(pair.numbers_minus).take(pair.minus);
        compare(pair);
    }

    void follow(const Apart<T>& pair, const ActiveSet<T>& active) const
    {
        P *errors = rows_at<P>(pair.errors, 0), *others = errors + active.rows;
        hold(pair.numbers_plus, pair.plus, active, errors),
            hold(pair.numbers_minus, pair.minus, active, others);
        const GroupLayout at = layout();
        P *v = rows_at<P>(pair.plus, at.v), *u = rows_at<P>(pair.minus, at.v);
        const P half(T(0.5)), h(T(options.h));
        for (int r = 0; r < active.rows; ++r) errors[r] = half * (errors[r] - others[r]);
        for (int i = 0; i < model.velocities; ++i) {
            P change(0);
            for (int r = 0; r < active.rows; ++r)
                change = change + P(active.gain[i * active.rows + r]) * errors[r];
            v[i] = v[i] - change, u[i] = u[i] + change;
        }
        integrate(model, v, h, rows_at<P>(pair.plus, at.q)),
            integrate(model, u, h, rows_at<P>(pair.minus, at.q));
    }

    // The step without its solve: v+ and activations to the group, errors of the active rows to `errors`.
    void hold(const T* numbers, T* group, const ActiveSet<T>& active, P* errors) const
    {
        step(numbers).prepare(group, active.row);
        find_velocity(model, work, work.z, work.v);
        const GroupLayout at = layout();
        P *v = rows_at<P>(group, at.v), *activations = rows_at<P>(group, at.activations);
        for (int i = 0; i < model.velocities; ++i) v[i] = work.v[i];
        for (int i = 0; i < model.filters; ++i) activations[i] = work.activations[i];
        for (int r = 0; r < active.rows; ++r) errors[r] = P(0);
        for (int i = 0; i < work.single_count; ++i) measure(work.singles[i], active, errors);
        for (int i = 0; i < work.contact_count; ++i) measure(work.contacts[i], active, errors);
    }

    P bias_of(const P& bias, const P& gap, int impulse, const ActiveSet<T>& active) const
    {
        return active.follows_gap[impulse] ? P(active.slope[impulse]) * gap : bias;
    }

    void measure(const SingleRow<P>& row, const ActiveSet<T>& active, P* errors) const
    {
        const int its = impulse_of(row.impulse), r = active.row[its];
        if (r < 0) return;
        P u(0);
        for (int k = 0; k < row.width; ++k) u = u + row.y[k] * *row.z[k];
        errors[r] = row.sign * u - bias_of(row.bias, row.gap, its, active) + row.soft * *row.impulse;
    }

    P velocity(const ContactRow<P>& row, int direction) const
    {
        P* const* zs = work.support_z + row.support->first;
        const int width = row.support->width;
        const P* y = row.y + direction * width;
        P u(0);
        for (int l = 0; l < width; ++l) u = u + y[l] * *zs[l];
        return u;
    }

    void measure(const ContactRow<P>& row, const ActiveSet<T>& active, P* errors) const
    {
        const int its = impulse_of(row.impulse), r = active.row[its];
        if (r < 0) return;
        errors[r] = velocity(row, 0) - bias_of(row.bias, row.gap, its, active) + row.soft * row.impulse[0];
        if (active.row[its + 1] < 0) return;
        const P u = velocity(row, 1), w = velocity(row, 2);
        const Slide<T>& slide = active.slide[its / 3];
        if (!slide.slides) {
            errors[r + 1] = u, errors[r + 2] = w;
            return;
        }
        const P du = u - P(slide.u0[0]), dw = w - P(slide.u0[1]), radius = row.friction * P(slide.n);
        errors[r + 1] = radius * (P(slide.turn[0]) + P(slide.bend[0]) * du + P(slide.bend[1]) * dw);
        errors[r + 2] = radius * (P(slide.turn[1]) + P(slide.bend[1]) * du + P(slide.bend[2]) * dw);
    }

    void compare(const Apart<T>& pair) const
    {
        const GroupLayout at = layout();
        const auto row = [&](T* group, int i) { return rows_at<P>(group, i); };
        const P rate = *row(const_cast<T*>(pair.rate), 0);
        P* out = row(pair.out, 0);
        for (T* group : {pair.plus, pair.minus}) turn_rates(model, row(group, at.q), false, row(group, at.v));
        difference(model, row(pair.minus, at.q), row(pair.plus, at.q), rate, out);
        subtract(row(pair.plus, at.v), row(pair.minus, at.v), rate, model.velocities, out + model.velocities);
        subtract(row(pair.plus, at.activations), row(pair.minus, at.activations), rate, model.filters,
                 out + 2 * model.velocities);
        const P bad = *row(pair.plus, at.bad) + *row(pair.minus, at.bad), nothing(__builtin_nanf(""));
        for (int i = 0; i < 2 * model.velocities + model.filters; ++i)
            out[i] = if_positive(bad, nothing, out[i]);
    }

    static void subtract(const P* a, const P* b, const P& rate, int count, P* out)
    {
        for (int i = 0; i < count; ++i) out[i] = rate * (a[i] - b[i]);
    }

    // ---- rows of a copy that stands in every lane, with the impulses that solve its step ----

    // Of each row y and M^-1 J', numbers of all dofs. Returns how many rows.
    int respond(const T* numbers, T* group, FoundRow<T>* rows, T* y, T* response) const
    {
        step(numbers).prepare(group);
        for (int i = 0; i < model.velocities; ++i) work.before[i] = work.z[i];
        int count = 0;
        for (int i = 0; i < work.single_count; ++i) {
            const SingleRow<P>& row = work.singles[i];
            rows[count] = {impulse_of(row.impulse),
                           false,
                           (*row.impulse)[0],
                           T(0),
                           row.sign[0],
                           row.soft[0],
                           row.low[0],
                           row.high[0],
                           T(0),
                           row.mass[0],
                           row.has_gap,
                           row.slope[0]};
            put_row(row.y, row.z, row.width, row.sign, rows[count], y + count * model.velocities,
                    response + count * model.velocities);
            ++count;
        }
        for (int i = 0; i < work.contact_count; ++i) {
            const ContactRow<P>& row = work.contacts[i];
            const int width = row.support->width;
            for (int k = 0; k < 3; ++k, ++count) {
                rows[count] = {impulse_of(row.impulse) + k,
                               true,
                               row.impulse[k][0],
                               T(0),
                               T(1),
                               row.soft[0],
                               T(0),
                               T(0),
                               row.friction[0],
                               row.mass[0],
                               true,
                               row.slope[0]};
                put_row(row.y + k * width, work.support_z + row.support->first, width, P(1), rows[count],
                        y + count * model.velocities, response + count * model.velocities);
            }
        }
        return count;
    }

    void put_row(const P* y, P* const* z, int width, const P& sign, FoundRow<T>& row, T* out,
                 T* response) const
    {
        for (int i = 0; i < model.velocities; ++i) work.z[i] = P(0);
        P u(0);
        for (int k = 0; k < width; ++k) {
            const P its = sign * y[k];
            u = u + its * work.before[z[k] - work.z];
            *z[k] = its;
        }
        find_velocity(model, work, work.z, work.v);
        for (int i = 0; i < model.velocities; ++i) out[i] = work.z[i][0], response[i] = work.v[i][0];
        row.velocity = u[0];
    }
};

}  // namespace
}  // namespace epode::batch
