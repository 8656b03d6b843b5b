// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Constraints that are near in some copy, as rows in the factor's space: y = D^-1/2 L^-T J', whose support is that of J with all its
// ancestors. In copies where a constraint is far its row has no inverse mass, so that its impulse stays 0: what neighbours do does not
// matter. Impulses of the last step, kept as forces, are where sweeps begin.
#pragma once

#include "batch/lanes/loops.h"
#include "batch/lanes/points.h"
#include "batch/lanes/sharing.h"
#include "batch/lanes/sums.h"

namespace epode::batch {
namespace {

// Any right-handed frame of a unit vector: Duff et al., Building an orthonormal basis, revisited, JCGT 6(1), 2017.
template <typename P>
EPODE_LANEWISE void tangents(const Vec3Of<P>& n, Vec3Of<P>& t1, Vec3Of<P>& t2)
{
    const P zero(0), one(1), sign = if_greater(zero, n.z, -one, one), a = -one / (sign + n.z),
                             b = n.x * n.y * a;
    t1 = {one + sign * (n.x * n.x * a), sign * b, -(sign * n.x)};
    t2 = {b, sign + n.y * n.y * a, -n.y};
}

template <typename P, bool own>
struct Rows {
    using T = typename P::Number;
    const ModelView& model;
    Numbers<P, own> numbers;
    const StepOptions& options;
    const P *q, *v, *forces;  // of the last step, of all constraints
    Work<P>& work;
    const int* acting =
        nullptr;  // of each impulse, if given: contacts and limits of which it is negative have no row, all others one

    bool acts(int impulse) const { return !acting || acting[impulse] >= 0; }

    void find() const
    {
        work.contact_count = work.turn_count = work.single_count = work.row_end = 0;
        for (int i = 0; i < model.dofs.size(); ++i) work.has_column[i] = false;
        if (model.loop_rows > 0) find_loops();
        for (const Dof& dof : model.dofs) {
            if (dof.dry >= 0) dry(dof);
            if (dof.servo >= 0) servo(dof);
            if (dof.limit >= 0) limit(dof);
        }
        if (model.sums.size() > 0) Sums<P, own>{model, numbers, options, q, v, forces, work}.find();
        Points<P, own>{model, numbers, options, work}.place();
        for (int i = 0; i < 3 * model.turns; ++i) work.impulses[model.first_turn() + i] = P(0);
        for (const BatchPair& pair : model.pairs) touch(pair);
    }

    // In `forces` and `impulses`: contacts, limits, dry friction, servos, sums, turning of contacts.
    int limit_at(const Dof& dof) const { return 3 * model.slots + dof.limit; }
    int dry_at(const Dof& dof) const { return 3 * model.slots + model.limits + dof.dry; }
    int servo_at(const Dof& dof) const { return 3 * model.slots + model.limits + model.dry + dof.servo; }
    int turn_at(const BatchPair& pair, int k) const { return model.first_turn() + 3 * (pair.first_turn + k); }

    // y of a unit force along the dof.
    P* column(const Dof& dof) const
    {
        const int number = model.chains[dof.chain + dof.depth];
        P* y = work.columns + dof.row;
        if (work.has_column[number]) return y;
        work.has_column[number] = true;
        const int* chain = model.chains.first + dof.chain;
        for (int k = 0; k < dof.depth; ++k) y[k] = P(0);
        y[dof.depth] = P(1);
        for (int k = dof.depth; k >= 0; --k) {
            const P* row = work.m + model.dofs[chain[k]].row;
            for (int l = 0; l < k; ++l) y[l] = y[l] - row[l] * y[k];
        }
        for (int k = 0; k <= dof.depth; ++k) y[k] = work.root[chain[k]] * y[k];
        return y;
    }

    Singles<P> singles() const { return {options, forces, work}; }
    Loops<P, own> loops() const { return {model, numbers, options, q, work}; }
    Direction<P> along(const Dof& dof) const
    {
        if (dof.wide >= 0) return widened(dof);
        return {column(dof), work.chain_z + dof.chain, dof.depth + 1};
    }

    void find_loops() const
    {
        for (int i = 0; i < model.dofs.size(); ++i) work.has_wide[i] = false;
        loops().find();
    }

    // What loops leave of the dof's column.
    Direction<P> widened(const Dof& dof) const
    {
        const Support& support = model.supports[dof.wide];
        const int number = model.chains[dof.chain + dof.depth];
        P *y = work.wide_y + dof.wide_y, *shares = work.shares + number * model.loop_rows;
        const Direction<P> out{y, work.support_z + support.first, support.width, shares};
        if (work.has_wide[number]) return out;
        work.has_wide[number] = true;
        const P* from = column(dof);
        for (int k = 0; k < support.width; ++k) y[k] = k < support.of_a ? from[k] : P(0);
        loops().project(y, model.places.first + support.places, shares);
        return out;
    }

    void dry(const Dof& dof) const
    {
        const P most = P(T(options.h)) * numbers[dof.first + dof_number::kFriction];
        SingleRow<P>& row = singles().add(along(dof), dry_at(dof), P(1), P(1), {P(0), P(0)});
        row.low = -most, row.high = most;
        singles().begin(row, dry_at(dof));
    }

    void servo(const Dof& dof) const
    {
        const ServoWork<P>& its = work.servos[dof.servo];
        work.impulses[servo_at(dof)] = P(0);
        if (!any_positive(its.wanted)) return;
        const P h(T(options.h)), gain = inverse_or_zero(its.gain), zero(0);
        const P most = if_positive(its.wanted, h * numbers[dof.first + dof_number::kForceLimit], zero);
        SingleRow<P>& row =
            singles().add(along(dof), servo_at(dof), P(1), its.wanted, {its.force * gain, gain / h});
        row.low = -most, row.high = most;
        singles().begin(row, servo_at(dof));
    }

    void limit(const Dof& dof) const
    {
        const int at = limit_at(dof), number = model.chains[dof.chain + dof.depth];
        const P position = q[model.joints[dof.joint].position], zero(0), one(1);
        const P below = position - numbers[dof.first + dof_number::kLow],
                above = numbers[dof.first + dof_number::kHigh] - position;
        const P sign = if_greater(below, above, -one, one), gap = at_most(below, above);
        const P reach = P(T(kNearLimit)) + P(T(2 * options.h)) * magnitude(v[number]);
        const P near = acting ? one : if_greater(reach, gap, one, zero);
        work.impulses[at] = zero;
        if (!acts(at) || !any_positive(near)) return;
        const Law<P> law = law_of(gap, numbers[dof.first + dof_number::kStopStiffness],
                                  numbers[dof.first + dof_number::kStopDamping], options);
        SingleRow<P>& row = singles().add(along(dof), at, sign, near, law);
        row.low = zero, row.high = if_positive(near, P(T(1e30)), zero);
        singles().begin(row, at);
    }

    bool acts(const BatchPair& pair) const
    {
        for (int k = 0; k < pair.slots; ++k)
            if (acts(3 * (pair.first_slot + k))) return true;
        return false;
    }

    void touch(const BatchPair& pair) const
    {
        if (!acts(pair)) return;
        Points<P, own>{model, numbers, options, work}.find(pair);
        const P* kept = forces + 3 * pair.first_slot;
        P shared[Work<P>::kMostPoints];
        const bool is_shared = pair.kind == PointKind::kAsked && pair.slots > 1;
        if (is_shared) share_load(work, kept, pair.slots, P(T(options.evening)), shared);
        for (int k = 0; k < pair.slots; ++k) {
            P* impulse = work.impulses + 3 * (pair.first_slot + k);
            impulse[0] = impulse[1] = impulse[2] = P(0);
            if (!acts(3 * (pair.first_slot + k))) continue;
            const P near = acting ? P(1) : nearness(pair, k);
            if (!any_positive(near)) continue;
            const P normal = is_shared ? shared[k] : kept[3 * k];
            contact(pair, k, near, {normal, kept[3 * k + 1], kept[3 * k + 2]}, impulse);
            if (pair.first_turn >= 0) turn(pair, k, near, impulse);
        }
    }

    Vec3Of<P> to_b(const Support& support) const
    {
        return work.origin[support.tree_b] - work.origin[support.tree_a];
    }

    // 1 where the gap is within reach of what the surfaces may approach in two steps.
    P nearness(const BatchPair& pair, int k) const
    {
        const Support& support = model.supports[pair.support];
        const int a = model.shapes[pair.shape_a].link, b = model.shapes[pair.shape_b].link;
        const Vec3Of<P>& point = work.points[k];
        const Spatial<P>& one = work.link[a].velocity;
        Vec3Of<P> apart = one.v + cross(one.w, point);
        if (support.of_b > 0) {
            const Spatial<P>& two = work.link[b].velocity;
            const Vec3Of<P> at = support.tree_a == support.tree_b ? point : point - to_b(support);
            apart = apart - (two.v + cross(two.w, at));
        }
        const P reach = P(T(options.reach)) + P(T(2 * options.h)) * magnitude(dot(work.normals[k], apart));
        return if_greater(reach, work.gaps[k], P(1), P(0));
    }

    // J of one link along its own dofs, in three directions: of a point's moving, or of the link's turning.
    template <bool turns>
    EPODE_LANEWISE void fill(const Support& support, int from, int count, const Vec3Of<P>& point,
                             const Vec3Of<P>* axes, bool upright, bool negative, P* y, int width) const
    {
        for (int k = from; k < from + count; ++k) {
            const Spatial<P>& s = work.s[model.support_dofs[support.first + k]];
            Vec3Of<P> u = s.w;
            if constexpr (!turns) u = s.v + cross(s.w, point);
            if (negative) u = {-u.x, -u.y, -u.z};
            y[k] = upright ? u.z : dot(axes[0], u);
            y[width + k] = upright ? u.x : dot(axes[1], u);
            y[2 * width + k] = upright ? u.y : dot(axes[2], u);
        }
    }

    // y of the normal and two tangents.
    template <bool turns>
    EPODE_LANEWISE void fill_all(const BatchPair& pair, int number, P* y, P*& shares) const
    {
        const Support& support = model.supports[pair.support];
        const int width = support.width;
        Vec3Of<P> axes[3] = {work.normals[number], {}, {}};
        if (!pair.is_upright) tangents(axes[0], axes[1], axes[2]);
        for (int l = 0; l < support.common; ++l) y[l] = y[width + l] = y[2 * width + l] = P(0);
        fill<turns>(support, support.common, support.of_a, work.points[number], axes, pair.is_upright, false,
                    y, width);
        if (support.of_b > 0) {
            const Vec3Of<P> at =
                support.tree_a == support.tree_b ? work.points[number] : work.points[number] - to_b(support);
            fill<turns>(support, support.common + support.of_a, support.of_b, at, axes, pair.is_upright, true,
                        y, width);
        }
        carry(support, y);
        shares = nullptr;
        if (support.places >= 0) shares = project(support, y, turns);
    }

    // The three rows that are made now, of a contact or of its turning.
    P* project(const Support& support, P* y, bool turns) const
    {
        const int own_width = support.of_chains(), width = support.width,
                  number = turns ? model.slots + work.turn_count - 1 : work.contact_count - 1;
        P* shares = work.shares + model.loop_rows * (model.velocities + model.sums.size() + 3 * number);
        for (int i = 0; i < 3; ++i) {
            for (int k = own_width; k < width; ++k) y[i * width + k] = P(0);
            loops().project(y + i * width, model.places.first + support.places, shares + i * model.loop_rows);
        }
        return shares;
    }

    // L^-T and D^-1/2 along the support. Of b's own dofs chains go on behind those of a.
    EPODE_LANEWISE void carry(const Support& support, P* y) const
    {
        const int width = support.width, first_b = support.common + support.of_a;
        const int* dofs = model.support_dofs.first + support.first;
        for (int k = support.of_chains(); k-- > 0;) {
            const Dof& dof = model.dofs[dofs[k]];
            const P* row = work.m + dof.row;
            const P y0 = y[k], y1 = y[width + k], y2 = y[2 * width + k], root = work.root[dofs[k]];
            for (int l = 0; l < dof.depth; ++l) {
                const int to = k >= first_b && l >= support.common ? l + support.of_a : l;
                y[to] = y[to] - row[l] * y0;
                y[width + to] = y[width + to] - row[l] * y1;
                y[2 * width + to] = y[2 * width + to] - row[l] * y2;
            }
            y[k] = root * y0, y[width + k] = root * y1, y[2 * width + k] = root * y2;
        }
    }

    void contact(const BatchPair& pair, int k, const P& near, const Vec3Of<P>& kept, P* impulse) const
    {
        const Support& support = model.supports[pair.support];
        const int width = support.width;
        ContactRow<P>& row = work.contacts[work.contact_count++];
        row.support = &support, row.y = work.rows + work.row_end, row.impulse = impulse;
        work.row_end += 3 * width;
        fill_all<false>(pair, k, row.y, row.shares);
        const Law<P> law = law_of(work.gaps[k], numbers[pair.first + pair_number::kStiffness],
                                  numbers[pair.first + pair_number::kDamping], options);
        row.bias = law.bias, row.soft = law.soft, row.gap = law.gap, row.slope = law.slope;
        row.friction = if_positive(near, numbers[pair.first + pair_number::kFriction], P(0));
        find_block(row, width, near);
        begin(row.support, row.y, row.d, kept, row.impulse);
    }

    EPODE_LANEWISE void find_block(ContactRow<P>& row, int width, const P& near) const
    {
        P d(0), a(0), b(0), c(0), n1(0), n2(0);
        for (int l = 0; l < width; ++l) {
            const P y0 = row.y[l], y1 = row.y[width + l], y2 = row.y[2 * width + l];
            d = d + y0 * y0, a = a + y1 * y1, b = b + y1 * y2, c = c + y2 * y2, n1 = n1 + y0 * y1,
            n2 = n2 + y0 * y2;
        }
        const P zero(0);
        row.d = if_positive(near, d + row.soft, zero), row.mass = inverse_or_zero(row.d);
        row.n1 = n1, row.n2 = n2;
        row.tangents = disc_of(a, b, c, near);
    }

    EPODE_LANEWISE static Disc<P> disc_of(const P& a, const P& b, const P& c, const P& near)
    {
        const P half(T(0.5)), zero(0), mean = half * (a + c), apart = half * (a - c);
        const P e = if_positive(near, mean + square_root(apart * apart + b * b), zero);
        return {a, b, c, e, if_positive(near, inverse_or_zero(a * c - b * b), zero), inverse_or_zero(e)};
    }

    // Begun where the last step ended, as contacts are.
    void turn(const BatchPair& pair, int k, const P& near, const P* normal) const
    {
        const Support& support = model.supports[pair.support];
        const int width = support.width, at = turn_at(pair, k);
        TurnRow<P>& row = work.turns[work.turn_count++];
        row.support = &support, row.y = work.rows + work.row_end, row.normal = normal;
        row.impulse = work.impulses + at, row.rolls = pair.rolls;
        work.row_end += 3 * width;
        fill_all<true>(pair, k, row.y, row.shares);
        row.torsion = numbers[pair.first + pair_number::kTorsion],
        row.rolling = numbers[pair.first + pair_number::kRolling];
        P d(0), a(0), b(0), c(0);
        for (int l = 0; l < width; ++l) {
            const P y0 = row.y[l], y1 = row.y[width + l], y2 = row.y[2 * width + l];
            d = d + y0 * y0, a = a + y1 * y1, b = b + y1 * y2, c = c + y2 * y2;
        }
        row.d = if_positive(near, d, P(0)), row.mass = inverse_or_zero(row.d);
        row.tangents = disc_of(a, b, c, near);
        begin(row.support, row.y, near, {forces[at], forces[at + 1], forces[at + 2]}, row.impulse);
    }

    EPODE_LANEWISE void begin(const Support* support, const P* y, const P& near, const Vec3Of<P>& kept,
                              P* impulse) const
    {
        const int width = support->width;
        const P h(T(options.h)), zero(0);
        impulse[0] = if_positive(near, h * kept.x, zero);
        impulse[1] = if_positive(near, h * kept.y, zero);
        impulse[2] = if_positive(near, h * kept.z, zero);
        P* const* zs = work.support_z + support->first;
        for (int l = 0; l < width; ++l) {
            P& z = *zs[l];
            z = z + y[l] * impulse[0] + y[width + l] * impulse[1] + y[2 * width + l] * impulse[2];
        }
    }

    static constexpr double kNearLimit = 0.01;  // rad or m: limits nearer than this have rows
};

}  // namespace
}  // namespace epode::batch
