// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Loops hold by construction too: their rows Y in the factor's space (work.h) are made orthonormal, Y = R E, R lower triangular (Gram and
// Schmidt, twice), and all that the step does stays within what they leave free. Of z and of every other row y of the loops' dofs
//     z <- z - E'(E z),    y <- y - E'(E y),
// so that E z = 0 whatever impulses follow, without a sweep over loops; a row that others have already (a planar loop has one) falls
// away. Their own impulses l follow from what was taken: R' l = -E z0 - sum (E y) impulse.
// A step moves along the tangent. The gap g that is left, and what the curve will add are closed by a velocity of positions alone, which
// v and its energy do not feel: J v_p = -g / h - h/2 dJ/dt v, damped where J is nearly singular, and limited as corrections are.
// Rejected: blocks among the swept rows, which converge the slower the more loops and contacts there are.
#pragma once

#include "batch/lanes/mass.h"
#include "batch/lanes/motion.h"

namespace epode::batch {
namespace {

template <typename P, bool own>
struct Loops {
    using T = typename P::Number;
    const ModelView& model;
    Numbers<P, own> numbers;
    const StepOptions& options;
    const P* q;
    Work<P>& work;

    // Before any other row is made.
    void find() const
    {
        for (const BatchLoop& loop : model.loops) fill(loop);
        for (int first = 0; first < model.loop_rows; first += 3) make_orthonormal(first);
        for (int k = 0; k < model.loop_rows; ++k) work.loop_taken[k] = P(0);
        take_from_velocity();
    }

    int width() const { return model.loop_dofs.size(); }
    P* row(int k) const { return work.loop_y + k * width(); }
    P& r(int k, int i) const { return work.loop_r[k * model.loop_rows + i]; }

    P along(int k) const
    {
        const P* e = row(k);
        P sum(0);
        for (int j = 0; j < width(); ++j) sum = sum + e[j] * work.z[model.loop_dofs[j]];
        return sum;
    }

    void take_from_velocity() const
    {
        for (int k = 0; k < model.loop_rows; ++k) {
            const P taken = along(k), *e = row(k);
            for (int j = 0; j < width(); ++j) {
                P& z = work.z[model.loop_dofs[j]];
                z = z - taken * e[j];
            }
            work.loop_taken[k] = work.loop_taken[k] - taken;
        }
    }

    // Of a frame, from O of its link's tree.
    Vec3Of<P> place(int link, int first) const
    {
        return work.link[link].p + work.link[link].r * numbers.vec(first);
    }

    Vec3Of<P> origin(int link) const { return work.origin[link == 0 ? model.trees : model.links[link].tree]; }

    void fill(const BatchLoop& loop) const
    {
        const Vec3Of<P> a = place(loop.link_a, loop.first_a), b = place(loop.link_b, loop.first_b);
        P* y = row(loop.row);
        for (int i = 0; i < loop.rows() * width(); ++i) y[i] = P(0);
        add_motion(loop.link_a, a, P(1), loop.is_weld, y), add_motion(loop.link_b, b, P(-1), loop.is_weld, y);
        for (int k = 0; k < loop.rows(); ++k) carry(y + k * width());
        const P none(0), one(1);
        for (int k = loop.row; k < loop.row + loop.rows(); k += 3)
            work.loop_axes[k] = {one, none, none}, work.loop_axes[k + 1] = {none, one, none},
            work.loop_axes[k + 2] = {none, none, one};
    }

    // Acceleration of a point at steady velocities.
    static Vec3Of<P> bent(const LinkWork<P>& link, const Vec3Of<P>& at)
    {
        const Spatial<P>&v = link.velocity, &a = link.acceleration;
        return a.v + cross(a.w, at) + cross(v.w, v.v + cross(v.w, at));
    }

    void add_motion(int link, const Vec3Of<P>& at, const P& sign, bool turns, P* y) const
    {
        const int last = model.links[link].last_dof, n = width();
        if (last < 0) return;
        const Dof& dof = model.dofs[last];
        for (int k = 0; k <= dof.depth; ++k) {
            const int number = model.chains[dof.chain + k], j = model.loop_places[number];
            const Spatial<P>& s = work.s[number];
            const Vec3Of<P> u = s.v + cross(s.w, at);
            const P parts[6] = {u.x, u.y, u.z, s.w.x, s.w.y, s.w.z};
            for (int i = 0; i < (turns ? 6 : 3); ++i) y[i * n + j] = y[i * n + j] + sign * parts[i];
        }
    }

    // D^-1/2 L^-T; all ancestors of the loops' dofs are among them.
    void carry(P* y) const
    {
        for (int j = width(); j-- > 0;) {
            const int number = model.loop_dofs[j];
            const Dof& dof = model.dofs[number];
            const P* its = work.m + dof.row;
            for (int l = 0; l < dof.depth; ++l) {
                P& to = y[model.loop_places[model.chains[dof.chain + l]]];
                to = to - its[l] * y[j];
            }
            y[j] = work.root[number] * y[j];
        }
    }

    // Twice the vector of the turn that leads from frame b to frame a, the shorter way.
    Vec3Of<P> turned(const BatchLoop& loop) const
    {
        const Vec4Of<P> a = work.link[loop.link_a].q * numbers.quat(loop.first_a + 3),
                        b = work.link[loop.link_b].q * numbers.quat(loop.first_b + 3);
        const Vec4Of<P> e = a * Vec4Of<P>{b.w, -b.x, -b.y, -b.z};
        return if_greater(P(0), e.w, P(-2), P(2)) * Vec3Of<P>{e.x, e.y, e.z};
    }

    static P square_of(const P* y, int count)
    {
        P sum(0);
        for (int j = 0; j < count; ++j) sum = sum + y[j] * y[j];
        return sum;
    }

    // Three rows of one kind, the one that is left with most first; what is less than a share of all is rounding, or of the file.
    void make_orthonormal(int first) const
    {
        const P scale = square_of(row(first), 3 * width());
        for (int k = first; k < first + 3; ++k) {
            for (int i = 0; i < k; ++i) r(k, i) = P(0);
            for (int i = 0; i < first; ++i) take_row(k, i);
        }
        for (int k = first; k < first + 3; ++k) {
            for (int other = k + 1; other < first + 3; ++other) bring_longer_first(k, other);
            for (int i = 0; i < k; ++i) take_row(k, i);
            make_unit(k, scale);
            for (int other = k + 1; other < first + 3; ++other) take_row(other, k);
        }
    }

    void make_unit(int k, const P& scale) const
    {
        P* y = row(k);
        const P square = square_of(y, width());
        const P norm = if_greater(square, P(T(kLeast)) * scale, square_root(square), P(0)),
                inverse = inverse_or_zero(norm);
        for (int j = 0; j < width(); ++j) y[j] = inverse * y[j];
        r(k, k) = norm, work.loop_inverse[k] = inverse;
        work.loop_gain[k] = norm * inverse_or_zero(square + P(T(kDamped)) * scale);
    }

    void take_row(int k, int i) const
    {
        P* y = row(k);
        const P* e = row(i);
        P d(0);
        for (int j = 0; j < width(); ++j) d = d + e[j] * y[j];
        for (int j = 0; j < width(); ++j) y[j] = y[j] - d * e[j];
        r(k, i) = r(k, i) + d;
    }

    // Copy by copy: a change of places of two rows.
    void bring_longer_first(int k, int other) const
    {
        const P longer = square_of(row(other), width()) - square_of(row(k), width());
        const auto change = [&](P& a, P& b) {
            const P was = a;
            a = if_positive(longer, b, was), b = if_positive(longer, was, b);
        };
        for (int j = 0; j < width(); ++j) change(row(k)[j], row(other)[j]);
        for (int i = 0; i < k; ++i) change(r(k, i), r(other, i));
        Vec3Of<P>&a = work.loop_axes[k], &b = work.loop_axes[other];
        change(a.x, b.x), change(a.y, b.y), change(a.z, b.z);
    }

    // Another row, whose entries for the loops' dofs stand at those places; notes what was taken, E y. One of which nothing is left is 0.
    void project(P* y, const int* places, P* shares) const
    {
        P before(0), after(0);
        for (int j = 0; j < width(); ++j) before = before + y[places[j]] * y[places[j]];
        for (int k = 0; k < model.loop_rows; ++k) {
            const P* e = row(k);
            P d(0);
            for (int j = 0; j < width(); ++j) d = d + e[j] * y[places[j]];
            for (int j = 0; j < width(); ++j) y[places[j]] = y[places[j]] - d * e[j];
            shares[k] = d;
        }
        for (int j = 0; j < width(); ++j) after = after + y[places[j]] * y[places[j]];
        const P left = if_greater(after, P(T(kNothing)) * before, P(1), P(0));
        for (int j = 0; j < width(); ++j) y[places[j]] = left * y[places[j]];
    }

    // Once the rest is solved.
    void find_impulses() const
    {
        take_from_velocity();
        for (int i = 0; i < work.single_count; ++i) {
            const SingleRow<P>& its = work.singles[i];
            if (its.shares) give(its.shares, its.sign * *its.impulse);
        }
        for (int i = 0; i < work.contact_count; ++i)
            give_three(work.contacts[i].shares, work.contacts[i].impulse);
        for (int i = 0; i < work.turn_count; ++i) give_three(work.turns[i].shares, work.turns[i].impulse);
        put_impulses(work.impulses + model.first_loop());
    }

    // Once the velocities are known: how positions move.
    void close() const
    {
        Motion<P, own>{model, numbers, q, work.v, work}.find();
        for (const BatchLoop& loop : model.loops) put_back(loop);
        for (int i = 0; i < model.velocities; ++i) work.scattered[i] = work.z[i];
        for (int k = 0; k < model.loop_rows; ++k) {
            P& back = work.loop_back[k];
            for (int i = 0; i < k; ++i) back = back - r(k, i) * work.loop_back[i];
            back = work.loop_gain[k] * back;
            for (int j = 0; j < width(); ++j) {
                P& z = work.scattered[model.loop_dofs[j]];
                z = z + back * row(k)[j];
            }
        }
        find_velocity(model, work, work.scattered, work.moved);
    }

    // The gap that there would be after a step along the tangent, by second order.
    void put_back(const BatchLoop& loop) const
    {
        const P half(T(0.5 * options.h * options.h));
        const LinkWork<P>&one = work.link[loop.link_a], &two = work.link[loop.link_b];
        const Vec3Of<P> a = place(loop.link_a, loop.first_a), b = place(loop.link_b, loop.first_b);
        put_back(loop.row, (a - b) + (origin(loop.link_a) - origin(loop.link_b)) +
                               half * (bent(one, a) - bent(two, b)));
        if (!loop.is_weld) return;
        put_back(loop.row + 3, turned(loop) + half * (one.acceleration.w - two.acceleration.w));
    }

    void put_back(int first, const Vec3Of<P>& gap) const
    {
        const P rate(T(1 / options.h)), most(T(options.most_correction)),
            speed = rate * square_root(dot(gap, gap));
        const P share = rate * at_most(P(1), most * inverse_or_zero(speed));
        for (int k = first; k < first + 3; ++k)
            work.loop_back[k] = if_positive(speed, -(share * dot(work.loop_axes[k], gap)), P(0));
    }

    // Of the rows, as vectors in the world's axes.
    void put_impulses(P* out) const
    {
        for (int k = model.loop_rows; k-- > 0;) {
            P& rest = work.loop_taken[k];
            for (int n = k + 1; n < model.loop_rows; ++n) rest = rest - r(n, k) * work.loop_taken[n];
            rest = work.loop_inverse[k] * rest;
        }
        for (int first = 0; first < model.loop_rows; first += 3) {
            Vec3Of<P> sum = work.loop_taken[first] * work.loop_axes[first];
            for (int k = first + 1; k < first + 3; ++k) sum = sum + work.loop_taken[k] * work.loop_axes[k];
            out[first] = sum.x, out[first + 1] = sum.y, out[first + 2] = sum.z;
        }
    }

    void give(const P* shares, const P& impulse) const
    {
        for (int k = 0; k < model.loop_rows; ++k)
            work.loop_taken[k] = work.loop_taken[k] - shares[k] * impulse;
    }

    void give_three(const P* shares, const P* impulse) const
    {
        for (int i = 0; shares && i < 3; ++i) give(shares + i * model.loop_rows, impulse[i]);
    }

    static constexpr double kLeast = sizeof(T) == 4 ? 1e-9 : 1e-10, kDamped = 1e-4;
    static constexpr double kNothing =
        sizeof(T) == 4 ? 1e-9 : 1e-20;  // of a row of which loops have taken all
};

}  // namespace
}  // namespace epode::batch
