// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Block Gauss-Seidel on the factor's space: a row's velocity is y.z, its impulse dl changes z by y dl. Between two sweeps one step of
// Anderson's extrapolation: with f = G(x) - x and the last df = f - f_before,
//     theta = f.df / df.df,   x <- G(x) - theta (G(x) - G(x_before)),
// of z and, since z is affine in them, of the impulses alike; the next sweep projects. Each copy has its own theta and stops where no
// row's last change would move its velocity by more than the tolerance. From then on nothing of it changes.
// Friction is Coulomb's cone: where the tangents' block says that the contact sticks within the disc of radius mu n it does, else a
// gradient step with the block's largest eigenvalue, back onto the disc; both keep the law's solution. So does friction against rolling;
// that against turning about the normal is cut off at its bound.
// Sources: Anderson, Iterative procedures for nonlinear integral equations, J. ACM 12, 1965; Jourdan, Alart, Jean, A Gauss-Seidel like
// algorithm to solve frictional contact problems, Comput. Methods Appl. Mech. Eng. 155, 1998.
#pragma once

#include "batch/lanes/work.h"

namespace epode::batch {
namespace {

template <typename P>
struct Couple {
    P s, t;
};

template <typename P>
struct Solve {
    using T = typename P::Number;
    const ModelView& model;
    const StepOptions& options;
    Work<P>& work;

    EPODE_LANEWISE P visit(const SingleRow<P>& row, const P& pace) const
    {
        P* const* z = row.z;
        P velocity(0);
        for (int k = 0; k < row.width; ++k) velocity = velocity + row.y[k] * *z[k];
        const P old = *row.impulse,
                wanted = old - row.mass * (row.sign * velocity - row.bias + row.soft * old);
        const P asked = clip(wanted, row.low, row.high) - old, change = if_positive(pace, pace * asked, P(0)),
                along = row.sign * change;
        if (!any_positive(magnitude(change))) return row.d * magnitude(asked);
        *row.impulse = old + change;
        for (int k = 0; k < row.width; ++k) *z[k] = *z[k] + row.y[k] * along;
        return row.d * magnitude(asked);
    }

    // Impulses of two directions with speeds u where they are s and t: those that end both speeds, or on the disc.
    EPODE_LANEWISE static Couple<P> within(const Disc<P>& its, const P& s, const P& t, const P& u1,
                                           const P& u2, const P& radius)
    {
        const P square = radius * radius;
        const P stick1 = s - its.inverse * (its.c * u1 - its.b * u2),
                stick2 = t - its.inverse * (its.a * u2 - its.b * u1);
        const P slide1 = s - its.step * u1, slide2 = t - its.step * u2,
                length2 = slide1 * slide1 + slide2 * slide2;
        const P shrink = if_greater(length2, square, radius * inverse_or_zero(square_root(length2)), P(1));
        const P stuck = if_positive(its.inverse, square - (stick1 * stick1 + stick2 * stick2), P(-1));
        return {if_greater(P(0), stuck, shrink * slide1, stick1),
                if_greater(P(0), stuck, shrink * slide2, stick2)};
    }

    // Turning about the normal, then rolling.
    EPODE_LANEWISE P visit(const TurnRow<P>& row, const P& pace) const
    {
        P* const* zs = work.support_z + row.support->first;
        const int width = row.support->width;
        const P *y0 = row.y, *y1 = y0 + width, *y2 = y1 + width, zero(0);
        const P n = at_least(zero, *row.normal), t0 = row.impulse[0], t1 = row.impulse[1],
                t2 = row.impulse[2];
        if (!any_positive(n + magnitude(t0) + magnitude(t1) + magnitude(t2))) return zero;
        P u0(0), u1(0), u2(0);
        for (int l = 0; l < width; ++l) u0 = u0 + y0[l] * *zs[l];
        const P most = row.torsion * n, change = clip(t0 - row.mass * u0, -most, most) - t0,
                g0 = if_positive(pace, pace * change, zero);
        row.impulse[0] = t0 + g0;
        for (int l = 0; l < width; ++l) {
            P& z = *zs[l];
            z = z + y0[l] * g0;
            u1 = u1 + y1[l] * z, u2 = u2 + y2[l] * z;
        }
        if (!row.rolls) return row.d * magnitude(change);
        const Couple<P> found = within(row.tangents, t1, t2, u1, u2, row.rolling * n);
        const P d1 = found.s - t1, d2 = found.t - t2, g1 = if_positive(pace, pace * d1, zero),
                g2 = if_positive(pace, pace * d2, zero);
        row.impulse[1] = t1 + g1, row.impulse[2] = t2 + g2;
        for (int l = 0; l < width; ++l) *zs[l] = *zs[l] + y1[l] * g1 + y2[l] * g2;
        return at_least(row.d * magnitude(change), row.tangents.e * at_least(magnitude(d1), magnitude(d2)));
    }

    EPODE_LANEWISE P visit(const ContactRow<P>& row, const P& pace) const
    {
        P* const* zs = work.support_z + row.support->first;
        const int width = row.support->width;
        const P *y0 = row.y, *y1 = y0 + width, *y2 = y1 + width, zero(0);
        P u0(0), u1(0), u2(0);
        for (int l = 0; l < width; ++l) u0 = u0 + y0[l] * *zs[l];
        // Nothing pressed and nothing presses: there is no friction either.
        const P any = magnitude(row.impulse[0]) + magnitude(row.impulse[1]) + magnitude(row.impulse[2]);
        if (!any_positive(at_least(any, row.mass * (row.bias - u0)))) return zero;
        for (int l = 0; l < width; ++l) {
            const P z = *zs[l];
            u1 = u1 + y1[l] * z, u2 = u2 + y2[l] * z;
        }
        const Disc<P>& tangents = row.tangents;
        const P n = row.impulse[0], s = row.impulse[1], t = row.impulse[2];
        // Where it slides the tangents follow the normal: the normal's own problem is then d + mu e.n, e the direction of sliding.
        const P radius0 = row.friction * n,
                slides =
                    if_greater(s * s + t * t, P(T(kSliding)) * (radius0 * radius0), inverse_or_zero(n), zero);
        const P slope = slides * (row.n1 * s + row.n2 * t), least = P(T(kLeastSlope)) * row.d;
        const P steep = if_greater(row.d + slope, least, row.d + slope, row.d),
                mass = if_positive(row.mass, P(1) / steep, zero);
        const P normal = at_least(zero, n - mass * (u0 - row.bias + row.soft * n)), dn = normal - n;
        const P follow = slides * dn, s0 = s + follow * s, t0 = t + follow * t, fs = s0 - s, ft = t0 - t;
        u1 = u1 + row.n1 * dn + tangents.a * fs + tangents.b * ft,
        u2 = u2 + row.n2 * dn + tangents.b * fs + tangents.c * ft;
        const Couple<P> found = within(tangents, s0, t0, u1, u2, row.friction * (n + dn));
        const P ds = found.s - s, dt = found.t - t;
        const P gn = if_positive(pace, pace * dn, zero), gs = if_positive(pace, pace * ds, zero),
                gt = if_positive(pace, pace * dt, zero);
        row.impulse[0] = n + gn, row.impulse[1] = s + gs, row.impulse[2] = t + gt;
        for (int l = 0; l < width; ++l) {
            P& z = *zs[l];
            z = z + y0[l] * gn + y1[l] * gs + y2[l] * gt;
        }
        return at_least(row.d * magnitude(dn), tangents.e * at_least(magnitude(ds), magnitude(dt)));
    }

    EPODE_LANEWISE P sweep(const P& pace) const
    {
        P worst(0);
        for (int i = 0; i < work.single_count; ++i) worst = at_least(visit(work.singles[i], pace), worst);
        for (int i = 0; i < work.contact_count; ++i) worst = at_least(visit(work.contacts[i], pace), worst);
        for (int i = 0; i < work.turn_count; ++i) worst = at_least(visit(work.turns[i], pace), worst);
        return worst;
    }

    // Whatever a sweep of these rows may change.
    template <typename Each>
    EPODE_LANEWISE void each_impulse(const Each& each) const
    {
        for (int i = 0; i < work.single_count; ++i) each(int(work.singles[i].impulse - work.impulses));
        for (int i = 0; i < work.contact_count; ++i)
            for (int k = 0; k < 3; ++k) each(int(work.contacts[i].impulse - work.impulses) + k);
        for (int i = 0; i < work.turn_count; ++i)
            for (int k = 0; k < 3; ++k) each(int(work.turns[i].impulse - work.impulses) + k);
    }

    // work.before: z before the sweep; change: f of the sweep before; last: z after it.
    void begin() const
    {
        for (int i = 0; i < model.velocities; ++i) work.last[i] = work.z[i], work.change[i] = P(0);
        each_impulse([&](int i) EPODE_INLINE_LAMBDA { work.last_impulses[i] = work.impulses[i]; });
    }

    void extrapolate(const P& alive, bool is_first) const
    {
        P up(0), down(0), now2(0), then2(0);
        for (int i = 0; i < model.velocities; ++i) {
            const P f = work.z[i] - work.before[i], then = work.change[i], df = f - then;
            up = up + f * df, down = down + df * df, now2 = now2 + f * f, then2 = then2 + then * then;
            work.change[i] = f;
        }
        const P zero(0), bounded = clip(up * inverse_or_zero(down), P(T(-kFarthest)), P(1));
        const P theta = is_first ? zero : if_positive(alive, if_greater(now2, then2, zero, bounded), zero);
        for (int i = 0; i < model.velocities; ++i) {
            const P z = work.z[i];
            work.z[i] = z - theta * (z - work.last[i]), work.last[i] = z;
        }
        each_impulse([&](int i) {
            const P x = work.impulses[i];
            work.impulses[i] = x - theta * (x - work.last_impulses[i]), work.last_impulses[i] = x;
        });
    }

    void find() const
    {
        P alive(1), worst(0), least(T(1e30)), idle(0);
        work.sweeps = P(0);
        begin();
        if (work.single_count + work.contact_count > 0)
            for (int i = 0; i < options.most_sweeps; ++i) {
                for (int k = 0; k < model.velocities; ++k) work.before[k] = work.z[k];
                const T ease = i < kEasy ? T(1) : T(i < kHard ? 0.5 : 0.25);
                const P change = sweep(P(ease) * alive);
                worst = if_positive(alive, change, worst);
                work.sweeps = work.sweeps + alive;
                const P gains = if_greater(P(T(kGain)) * least, worst, P(1), P(0));
                idle = if_positive(gains, P(0), idle + P(1)), least = if_positive(gains, worst, least);
                alive = if_greater(worst, P(T(options.tolerance)), alive, P(0));
                alive = if_greater(P(T(kPatience)), idle, alive,
                                   if_greater(worst, P(T(kSmall * options.tolerance)), alive, P(0)));
                if (!any_positive(alive) || i + 1 == options.most_sweeps) break;
                if (i + 1 < kEasy) extrapolate(alive, i == 0);
            }
        work.worst = worst;
    }

    static constexpr double kFarthest = 1000, kSliding = 0.99, kLeastSlope = 0.1;
    // Sliding contacts that disturb one another may go round in circles for ever: from then on steps are halved, then quartered.
    static constexpr int kEasy = 40, kHard = 100;
    // Redundant contacts that ask for slightly different things have impulses that grow while nothing moves: a copy whose residual has
    // not fallen by a tenth in so many sweeps stops, and says so by its residual.
    static constexpr double kGain = 0.9, kPatience = 12, kSmall = 100;
};

}  // namespace
}  // namespace epode::batch
