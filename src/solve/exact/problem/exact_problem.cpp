// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Kinematic bodies have no unknowns: their part of J v is moved to the right-hand side. A row with an empty
// Jacobian gets d = C, so that nothing is divided by zero.
#include "solve/exact/problem/exact_problem.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

// Microseconds: of a row and a body that become part of the problem, of a row in a pass over all; of a product of
// blocks, of a block in a solution, and of its analysis.
constexpr double kRowWork = 0.03, kBodyWork = 0.05, kRowPass = 0.008;
constexpr double kProductWork = 0.05, kBlockPass = 0.015, kAnalysisWork = 0.1;

void put(Vec3 a, double* out) { out[0] = a.x, out[1] = a.y, out[2] = a.z; }

// block += s x y^T, 6x6 column-major
void add_outer(double* block, double s, const double* x, const double* y)
{
    const DoubleLane* a = reinterpret_cast<const DoubleLane*>(x);
    DoubleLane* out = reinterpret_cast<DoubleLane*>(block);
    for (int c = 0; c < 6; ++c) {
        const double sy = s * y[c];
        for (int r = 0; r < 3; ++r) out[3 * c + r] += a[r] * sy;
    }
}

}  // namespace

bool ExactProblem::build(const RowSystem& system, WorkMeter* work, Arena& arena)
{
    work_ = work;
    count_work(kRowWork * double(system.rows.size()) + kBodyWork * double(system.bodies.size()));
    rows_ = arena.take<ExactRow>(int(system.rows.size()));
    if (arena.failed() || !number_bodies(system, arena) || !take_wide(system, arena)) return false;
    fill_rows(system);
    return true;
}

bool ExactProblem::take_wide(const RowSystem& system, Arena& arena)
{
    wide_rows_ = {}, wide_terms_ = {};
    if (system.terms.empty()) return true;
    int rows = 0;
    for (const RowBlock& block : system.blocks)
        if (block.term_count > 0) rows += block.count;
    wide_rows_ = arena.take<int>(rows);
    // The rows of a block each have their own: blocks may have been cut.
    int terms = 0;
    for (const RowBlock& block : system.blocks) terms += block.count * block.term_count;
    wide_terms_ = arena.take<WideTerm6>(terms);
    return !arena.failed();
}

bool ExactProblem::number_bodies(const RowSystem& system, Arena& arena)
{
    const int count = int(system.bodies.size());
    dynamic_ = arena.take<int>(count);
    roots_ = arena.take<BodyRoot>(count);
    v_star_ = arena.take<double>(6 * count);
    if (arena.failed()) return false;
    std::size_t n = 0;
    for (int i = 0; i < count; ++i) {
        const SolverBody& body = system.bodies[std::size_t(i)];
        dynamic_[std::size_t(i)] = body.inv_mass > 0 ? int(n) : -1;
        if (body.inv_mass <= 0) continue;
        const BodyRoot& root = roots_[n] = root_of(body);
        double* v = &v_star_[6 * n++];
        put(body.v, v), put(body.w, v + 3);
        for (int k = 0; k < 3; ++k) v[k] *= root.root;
        v[3] = v[3] / root.r0 + root.l10 * v[4] + root.l20 * v[5];
        v[4] = v[4] / root.r1 + root.l21 * v[5];
        v[5] = v[5] / root.r2;
    }
    roots_ = roots_.first(n);
    v_star_ = v_star_.first(6 * n);
    return true;
}

ExactProblem::BodyRoot ExactProblem::root_of(const SolverBody& body)
{
    constexpr double kFlat = 1e-14;  // of the diagonal: an inertia that is singular to rounding
    const Sym3& I = body.inertia;
    const auto reciprocal = [](double square, double diagonal) {
        return 1 / std::sqrt(std::max(square, kFlat * diagonal));
    };
    BodyRoot out;
    out.root = std::sqrt(double(body.mass));
    out.inv_root = 1 / out.root;
    out.r0 = reciprocal(I.xx, I.xx);
    out.l10 = I.xy * out.r0;
    out.l20 = I.xz * out.r0;
    out.r1 = reciprocal(I.yy - out.l10 * out.l10, I.yy);
    out.l21 = (I.yz - out.l20 * out.l10) * out.r1;
    out.r2 = reciprocal(I.zz - out.l20 * out.l20 - out.l21 * out.l21, I.zz);
    return out;
}

void ExactProblem::to_root(const BodyRoot& root, double* six)
{
    for (int i = 0; i < 3; ++i) six[i] *= root.inv_root;
    six[3] *= root.r0;
    six[4] = (six[4] - root.l10 * six[3]) * root.r1;
    six[5] = (six[5] - root.l20 * six[3] - root.l21 * six[4]) * root.r2;
}

void ExactProblem::from_root(const BodyRoot& root, double* six)
{
    for (int i = 0; i < 3; ++i) six[i] *= root.inv_root;
    six[5] *= root.r2;
    six[4] = (six[4] - root.l21 * six[5]) * root.r1;
    six[3] = (six[3] - root.l10 * six[4] - root.l20 * six[5]) * root.r0;
}

// Counted by the structure alone: whether the analysis was in the cache depends on what other threads have done.
void ExactProblem::note_work()
{
    const SymbolicFactor& factor = symbolic_.symbolic();
    double products = 0;
    for (const Front& front : factor.fronts) {
        const double w = front.width, b = front.below;
        products += w * (w + 1) * (w + 2) / 6 + b * w * (w + 1) / 2 + w * b * (b + 1) / 2;
    }
    const double rows = double(rows_.size());
    factor_work_ = kProductWork * products + kRowPass * rows;
    solve_work_ = kBlockPass * factor.blocks + 2 * kRowPass * rows;
    count_work(kAnalysisWork * factor.blocks);
}

bool ExactProblem::build_factor(const RowSystem& system, SymbolicCache* symbolic_cache, const Tasks& tasks,
                                Arena& arena)
{
    const int blocks = int(system.blocks.size());
    int more = 0;
    for (const int wide : wide_rows_) more += row(wide).wide_count * (row(wide).wide_count - 1) / 2;
    auto pairs = arena.take<BodyPair>(blocks + more);
    pairs_ = arena.take<PairBlocks>(blocks);
    if (arena.failed()) return false;
    for (int k = 0; k < blocks; ++k) {
        const RowBlock& block = system.blocks[std::size_t(k)];
        int a = dynamic_[std::size_t(block.body1)];
        int b = block.body2 >= 0 ? dynamic_[std::size_t(block.body2)] : -1;
        // Packs of rows of one body go to its block, whichever of them is first.
        if (block.term_count > 0) a = b = row(block.first).a;
        if (a < 0) a = b;
        if (b < 0) b = a;
        pairs[std::size_t(k)] = {a, b};
    }
    std::size_t next = std::size_t(blocks);
    for (const int wide : wide_rows_)
        for (const WideTerm6& a : row(wide).terms())
            for (const WideTerm6* b = row(wide).wide; b != &a; ++b) pairs[next++] = {a.body, b->body};
    if (!symbolic_.take(int(roots_.size()), pairs, symbolic_cache, arena) ||
        !H_.prepare(symbolic_.symbolic(), tasks, arena))
        return false;
    note_work();
    for (int k = 0; k < blocks; ++k) {
        const auto [a, b] = pairs[std::size_t(k)];
        PairBlocks& s = pairs_[std::size_t(k)];
        s = {H_.diagonal(a), H_.diagonal(b), nullptr, false};
        if (a != b) s.ab = H_.between(a, b, s.transposed);
    }
    return true;
}

// Also raises the scale to max(|c - J v*|, |J| |v*| / 1000).
inline void ExactProblem::fill_row(const Row& row, const RowNumbers& n, const RowBlock& block,
                                   const RowSystem& system, ExactRow& out)
{
    double* half = out.J;
    int* body = &out.a;
    double sum = 0, motion = 0, inverse_mass = 0;
    out.c = n.c;
    out.C = n.C;
    out.b = -1;
    const auto take = [&](int island_body, Vec3 lin, Vec3 ang) {
        if (island_body < 0) return;
        const SolverBody& s = system.bodies[std::size_t(island_body)];
        const int index = dynamic_[std::size_t(island_body)];
        const double along = dot(lin, s.v), about = dot(ang, s.w);
        if (index < 0) {
            out.c -= along + about;
            return;
        }
        sum += along + about;
        motion += std::fabs(along) + std::fabs(about);
        double J[6];
        put(lin, J), put(ang, J + 3);
        to_root(roots_[std::size_t(index)], J);
        // In registers: reading pairs from memory where single numbers have just been written would wait for
        // them.
        const DoubleLane pairs[] = {{J[0], J[1]}, {J[2], J[3]}, {J[4], J[5]}};
        inverse_mass += six_dot(pairs, pairs);
        std::copy_n(pairs, 3, reinterpret_cast<DoubleLane*>(half));
        half = out.J + 6;
        *body = index;
        body = &out.b;
    };
    take(block.body1, row.lin1, row.ang1);
    take(block.body2, row.lin2, row.ang2);
    scale_ = std::max({scale_, std::fabs(out.c - sum), 1e-3 * motion});
    out.d = inverse_mass + out.C;
    out.weight_min = 1e-11 * out.d;
}

// With an empty J on a body of its own, for what only looks at pairs of bodies.
void ExactProblem::fill_wide_row(int i, const RowNumbers& n, const RowBlock& block, const RowSystem& system,
                                 ExactRow& out)
{
    wide_rows_ = {wide_rows_.data(), wide_rows_.size() + 1};
    wide_rows_.back() = i;
    double sum = 0, motion = 0, inverse_mass = 0;
    std::fill(out.J, out.J + 12, 0.0);
    out.c = n.c, out.C = n.C, out.a = 0, out.b = -1;
    out.wide = wide_terms_.data();
    for (const WideTerm& term : terms_of(system, block)) {
        const SolverBody& s = system.bodies[std::size_t(term.body)];
        const int index = dynamic_[std::size_t(term.body)];
        const double along = dot(term.lin, s.v), about = dot(term.ang, s.w);
        if (index < 0) {
            out.c -= along + about;
            continue;
        }
        sum += along + about;
        motion += std::fabs(along) + std::fabs(about);
        WideTerm6& to = wide_terms_[std::size_t(out.wide_count++)];
        to.body = out.a = index;
        put(term.lin, to.J), put(term.ang, to.J + 3);
        to_root(roots_[std::size_t(index)], to.J);
        inverse_mass += six_dot(to.J, to.J);
    }
    wide_terms_ = wide_terms_.subspan(std::size_t(out.wide_count));
    scale_ = std::max({scale_, std::fabs(out.c - sum), 1e-3 * motion});
    out.d = inverse_mass + out.C;
    out.weight_min = 1e-11 * out.d;
}

bool ExactProblem::soften()
{
    bool any = false;
    for (ExactRow& row : rows_) {
        if (row.C > 0 || !(row.d > 0)) continue;
        row.C = row.weight_min;
        any = true;
    }
    return any;
}

// Starts with H = 1, which is M in these coordinates.
void ExactProblem::begin_factor()
{
    H_.clear();
    for (std::size_t n = 0; n < roots_.size(); ++n) {
        double* h = H_.diagonal(int(n));
        for (int i = 0; i < 6; ++i) h[7 * i] = 1;
    }
    ++factorisations_;
    count_work(factor_work_);
}

void ExactProblem::fill_rows(const RowSystem& system)
{
    scale_ = 0;
    wide_rows_ = wide_rows_.first(0);
    for (std::size_t k = 0; k < system.blocks.size(); ++k) {
        const RowBlock& block = system.blocks[k];
        const bool wide = block.term_count > 0;
        for (int i = block.first; i < block.first + block.count; ++i) {
            ExactRow& row = rows_[std::size_t(i)];
            row.pair = int(k);
            row.wide_count = 0, row.wide = nullptr;
            const RowNumbers& numbers = system.numbers[std::size_t(i)];
            if (!wide)
                fill_row(system.rows[std::size_t(i)], numbers, block, system, row);
            else
                fill_wide_row(i, numbers, block, system, row);
        }
    }
    if (!(scale_ > 0)) scale_ = 1;
}

// H += weight J^T J
void ExactProblem::add_wide(WideJacobian row, double weight)
{
    for (std::size_t i = 0; i < row.size(); ++i) {
        const WideTerm6& a = row[i];
        add_outer(H_.diagonal(a.body), weight, a.J, a.J);
        for (const WideTerm6& b : row.first(i)) {
            bool transposed = false;
            double* const block = H_.between(a.body, b.body, transposed);
            transposed ? add_outer(block, weight, b.J, a.J) : add_outer(block, weight, a.J, b.J);
        }
    }
}

int ExactProblem::factor(std::span<const double> D)
{
    begin_factor();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (!(D[i] > 0)) continue;
        const ExactRow& row = rows_[i];
        if (row.wide_count > 0) {
            add_wide(row.terms(), D[i]);
            continue;
        }
        const PairBlocks& s = pairs_[std::size_t(row.pair)];
        const double* Ja = row.J;
        const double* Jb = row.J + 6;
        // A pair of which one body is kinematic has both slots on the dynamic one.
        add_outer(s.aa, D[i], Ja, Ja);
        if (row.b < 0) continue;
        add_outer(s.bb, D[i], Jb, Jb);
        s.transposed ? add_outer(s.ab, D[i], Jb, Ja) : add_outer(s.ab, D[i], Ja, Jb);
    }
    return H_.factor();
}

int ExactProblem::factor(std::span<const RowGroup> groups, std::span<const double> D,
                         const RowKernels& kernels, std::span<const double> wide_weights)
{
    begin_factor();
    kernels.assemble(groups.data(), int(groups.size()), D.data(), pairs_.data());
    for (std::size_t k = 0; k < wide_rows_.size(); ++k)
        if (wide_weights[k] > 0) add_wide(row(wide_rows_[k]).terms(), wide_weights[k]);
    return H_.factor();
}

void ExactProblem::momentum_change(std::span<const double> v, std::span<double> r) const
{
    for (std::size_t i = 0; i < v.size(); ++i) r[i] = v_star_[i] - v[i];
}

void ExactProblem::velocities(std::span<const double> p, std::span<double> v) const
{
    std::copy(v_star_.begin(), v_star_.end(), v.begin());
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (p[i] != 0) add_jt(rows_[i], p[i], v.data());
}

void ExactProblem::velocities_after(std::span<const double> momentum, std::span<double> v) const
{
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = v_star_[i] + momentum[i];
}

// sums = J^T (p + low); an empty `low` is zero.
void ExactProblem::sum_impulses(std::span<const double> p, std::span<const double> low,
                                std::span<DoubleDouble> sums) const
{
    std::fill(sums.begin(), sums.end(), DoubleDouble{});
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const ExactRow& row = rows_[i];
        if (p[i] == 0) continue;
        const DoubleDouble impulse{p[i], low.empty() ? 0 : low[i]};
        for (const WideTerm6& term : row.terms())
            for (int k = 0; k < 6; ++k) {
                DoubleDouble& sum = sums[std::size_t(6 * term.body + k)];
                sum = sum + impulse * term.J[k];
            }
        if (row.wide_count > 0) continue;
        for (int k = 0; k < 12; ++k) {
            const int body = k < 6 ? row.a : row.b;
            if (body < 0) break;
            DoubleDouble& sum = sums[std::size_t(6 * body + k % 6)];
            sum = sum + impulse * row.J[k];
        }
    }
}

void ExactProblem::velocities(std::span<const double> p, std::span<const double> low,
                              std::span<DoubleDouble> sums, std::span<double> v) const
{
    sum_impulses(p, low, sums);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = v_star_[i] + rounded(sums[i]);
}

void ExactProblem::defect(std::span<const double> p, std::span<const double> low,
                          std::span<const double> free, std::span<DoubleDouble> sums,
                          std::span<DoubleDouble> r) const
{
    sum_impulses(p, low, sums);
    for (std::size_t n = 0; n < v_star_.size(); ++n) sums[n] = sums[n] + v_star_[n];
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        r[i] = {};
        if (!(free[i] > 0)) continue;
        const ExactRow& row = rows_[i];
        DoubleDouble sum = DoubleDouble{p[i], low[i]} * -row.C + row.c;
        for (const WideTerm6& term : row.terms())
            for (int k = 0; k < 6; ++k) sum = sum - sums[std::size_t(6 * term.body + k)] * term.J[k];
        for (int k = 0; row.wide_count == 0 && k < (row.b < 0 ? 6 : 12); ++k)
            sum = sum - sums[std::size_t(6 * (k < 6 ? row.a : row.b) + k % 6)] * row.J[k];
        r[i] = sum;
    }
}

void ExactProblem::apply(std::span<const double> p, std::span<DoubleDouble> sums, std::span<double> v,
                         std::span<double> Ap) const
{
    sum_impulses(p, {}, sums);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = rounded(sums[i]);
    for (std::size_t i = 0; i < Ap.size(); ++i) Ap[i] = jv(rows_[i], v.data()) + rows_[i].C * p[i];
}

double ExactProblem::residual(const BoxState& state, std::span<double> v) const
{
    velocities(state.p, v);
    return residual_at(state, v);
}

double ExactProblem::residual_at(const BoxState& state, std::span<const double> v) const
{
    double worst = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const ExactRow& row = rows_[i];
        if (!(row.d > 0)) continue;
        const double p = state.p[i];
        const double w = jv(row, v.data()) + row.C * p - row.c;
        worst = std::max(worst, std::fabs(violation_of(w, row.d, p, state.lo[i], state.hi[i])));
    }
    return worst / scale_;
}

void ExactProblem::store(RowSystem& system, std::span<const double> p, std::span<const double> v) const
{
    for (std::size_t i = 0; i < rows_.size(); ++i) system.numbers[i].p = Real(p[i]);
    for (std::size_t k = 0; k < dynamic_.size(); ++k) {
        if (dynamic_[k] < 0) continue;
        const auto first = std::size_t(6 * dynamic_[k]);
        double change[6];
        for (std::size_t i = 0; i < 6; ++i) change[i] = v[first + i] - v_star_[first + i];
        from_root(roots_[std::size_t(dynamic_[k])], change);
        system.bodies[k].v += Vec3{Real(change[0]), Real(change[1]), Real(change[2])};
        system.bodies[k].w += Vec3{Real(change[3]), Real(change[4]), Real(change[5])};
    }
}

}  // namespace epode
