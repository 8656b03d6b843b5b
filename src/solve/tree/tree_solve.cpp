// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/tree/tree_solve.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr double kWanted = sizeof(Real) == 8 ? 1e-10 : 1e-6, kPromised = sizeof(Real) == 8 ? 1e-9 : 1e-5;
constexpr double kCoulomb = sizeof(Real) == 8 ? 1e-7 : 1e-5;
// Without any compliance a load has many distributions over redundant contacts (solve/exact/frozen_friction.cpp).
constexpr double kLeastCompliance = sizeof(Real) == 8 ? 1e-8 : 1e-6;

double product(const double* a, const double* b, std::size_t n)
{
    double sum[4] = {};
    std::size_t i = 0;
    for (; i + 4 <= n; i += 4)
        for (std::size_t k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
    for (; i < n; ++i) sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace

bool TreeSolve::prepare(RowSystem& system, const JointTree& tree, Arena& arena)
{
    system_ = &system, tree_ = &tree;
    const int n = tree.dofs(), m = int(system.rows.size()), links = int(tree.links().size());
    u_ = arena.take<double>(n), z_ = arena.take<double>(n), solved_ = arena.take<double>(n);
    scratch_ = arena.take<Spatial>(links);
    for (std::span<double>& spins : spins_) spins = arena.take<double>(n);
    if (arena.failed() || !factor_.prepare(tree, arena)) return false;
    factor_.assemble(tree, [&](const TreeLink& link) {
        const SolverBody& body = system.bodies[std::size_t(link.body)];
        return LinkInertia{body.mass, body.inertia};
    });
    (void)m;
    if (!collect(arena)) return false;
    fits_ = int(rows_.size()) <= kMaxRows;
    if (!fits_) return true;
    for (std::size_t i = 0; i < scratch_.size(); ++i) {
        const SolverBody& body = system.bodies[std::size_t(tree.link(int(i)).body)];
        scratch_[i] = {body.inertia * body.w, body.mass * body.v};
    }
    tree.gather(scratch_, z_);
    for (const Yield& yield : yields_)
        for (int i = 0; i < yield.count; ++i)
            z_[std::size_t(yield.first + i)] += yield.j[i] * yield.c / yield.C;
    add_yields_to(factor_);
    factor_.factor();
    factor_.to_factor_space(z_);
    Y_ = arena.take<double>(int(rows_.size()) * n);
    acting_ = arena.take<int>(int(rows_.size()));
    if (arena.failed() || !problem_.prepare(int(rows_.size()), arena)) return false;
    write_rows();
    return true;
}

bool TreeSolve::collect(Arena& arena)
{
    const int m = int(system_->rows.size());
    rows_ = arena.take<TreeRow>(m), yields_ = arena.take<Yield>(m), row_of_source_ = arena.take<int>(m);
    if (arena.failed()) return false;
    std::size_t rows = 0, yields = 0;
    std::fill(row_of_source_.begin(), row_of_source_.end(), -1);
    const std::span<Yield> all = yields_;
    for (std::size_t k = 0; k < system_->blocks.size(); ++k) {
        const RowBlock& block = system_->blocks[k];
        int first = 0;
        for (const int body : {block.body1, block.body2}) {
            const int at = block.contact || block.term_count > 0 ? -1 : tree_->link_of_body(body);
            if (at >= 0 && tree_->link(at).block == int(k)) first = lock_rows(tree_->link(at).joint);
        }
        for (int i = block.first + first; i < block.first + block.count; ++i) {
            yields_ = all.first(yields + 1);
            if (take_yield(block, i)) {
                ++yields;
                continue;
            }
            row_of_source_[std::size_t(i)] = int(rows);
            rows_[rows++] = {i, int(k), 1};
        }
    }
    rows_ = rows_.first(rows), yields_ = all.first(yields);
    return true;
}

bool TreeSolve::is_joint_of(int link, int parent) const
{
    if (link < 0) return false;
    const TreeLink& its = tree_->link(link);
    return its.parent == parent && its.joint != LinkJoint::kFree;
}

// Between a link and its parent only the link's own dofs move.
bool TreeSolve::take_yield(const RowBlock& block, int source)
{
    const RowNumbers& n = system_->numbers[std::size_t(source)];
    if (block.contact || block.term_count > 0 || n.bounded() || n.parent >= 0 || !(n.C > 0)) return false;
    const int a = tree_->link_of_body(block.body1), b = tree_->link_of_body(block.body2);
    const bool is_first = is_joint_of(a, b);
    if (!is_first && !is_joint_of(b, a)) return false;
    const TreeLink& link = tree_->link(is_first ? a : b);
    if ((is_first ? block.body2 : block.body1) >= 0 && link.parent < 0)
        return false;  // a kinematic body that may move
    const Row& row = system_->rows[std::size_t(source)];
    const Spatial f = is_first ? on_body(a, row.lin1, row.ang1) : on_body(b, row.lin2, row.ang2);
    Yield& yield = yields_.back();
    yield = {source, link.first, link.count, double(n.C), double(n.c), {}};
    for (int i = 0; i < link.count; ++i) yield.j[i] = double(dot(tree_->motion(link.first + i), f));
    return true;
}

Spatial TreeSolve::on_body(int link, Vec3 force, Vec3 torque) const
{
    return JointTree::about_root(tree_->link(link), force, torque);
}

void TreeSolve::add_own(const TreeLink& link, const Spatial& f, std::span<double> j) const
{
    for (int i = link.first; i < link.first + link.count; ++i)
        j[std::size_t(i)] += double(dot(tree_->motion(i), f));
}

void TreeSolve::add_chain(int link, const Spatial& f, std::span<double> j) const
{
    if (link < 0) return;
    for (int i = tree_->link(link).last; i >= 0; i = tree_->up(i))
        j[std::size_t(i)] += double(dot(tree_->motion(i), f));
}

void TreeSolve::jacobian(const RowBlock& block, const Row& row, std::span<double> j) const
{
    std::fill(j.begin(), j.end(), 0);
    if (block.term_count > 0) {
        for (const WideTerm& term : terms_of(*system_, block))
            if (const int at = tree_->link_of_body(term.body); at >= 0)
                add_chain(at, on_body(at, term.lin, term.ang), j);
        return;
    }
    const int a = tree_->link_of_body(block.body1), b = tree_->link_of_body(block.body2);
    if (a >= 0 && b >= 0 && tree_->link(a).parent == b)
        return add_own(tree_->link(a), on_body(a, row.lin1, row.ang1), j);
    if (a >= 0 && b >= 0 && tree_->link(b).parent == a)
        return add_own(tree_->link(b), on_body(b, row.lin2, row.ang2), j);
    if (a >= 0) add_chain(a, on_body(a, row.lin1, row.ang1), j);
    if (b >= 0) add_chain(b, on_body(b, row.lin2, row.ang2), j);
}

// J v of bodies that no force moves.
double TreeSolve::kinematic_part(const RowBlock& block, const Row& row) const
{
    double sum = 0;
    const auto add = [&](int body, Vec3 lin, Vec3 ang) {
        if (body < 0 || tree_->link_of_body(body) >= 0) return;
        const SolverBody& its = system_->bodies[std::size_t(body)];
        sum += double(dot(lin, its.v) + dot(ang, its.w));
    };
    if (block.term_count > 0) {
        for (const WideTerm& term : terms_of(*system_, block)) add(term.body, term.lin, term.ang);
        return sum;
    }
    add(block.body1, row.lin1, row.ang1), add(block.body2, row.lin2, row.ang2);
    return sum;
}

void TreeSolve::write_rows()
{
    const std::size_t n = u_.size();
    scale_ = 0;
    for (int i = 0; i < int(rows_.size()); ++i) write_row(i);
    for (int i = 0; i < int(rows_.size()); ++i) {
        const TreeRow& its = rows_[std::size_t(i)];
        const RowBlock& block = system_->blocks[std::size_t(its.block)];
        double* const row = problem_.row(i);
        for (int k = 0; k <= i; ++k) row[k] = problem_.row(k)[i] = product(y(i), y(k), n);
        double C = its.ratio * its.ratio * double(system_->numbers[std::size_t(its.source)].C);
        if (block.coulomb) C = std::max(C, kLeastCompliance * row[i]);
        if (!(C > 0)) C = 1e-14 * row[i];
        row[i] += C;
        if (!(row[i] > 0)) row[i] = 1;  // it moves nothing
    }
    if (!(scale_ > 0)) scale_ = 1;
    bind_parents();
}

void TreeSolve::write_row(int i)
{
    TreeRow& its = rows_[std::size_t(i)];
    const RowBlock& block = system_->blocks[std::size_t(its.block)];
    const Row& row = system_->rows[std::size_t(its.source)];
    const RowNumbers& n = system_->numbers[std::size_t(its.source)];
    const std::span<double> its_y{y(i), u_.size()};
    jacobian(block, row, its_y);
    factor_.to_factor_space(its_y);
    FrictionRow& to = problem_.rows()[std::size_t(i)];
    to = {double(n.lo), double(n.hi), -1, false, false};
    problem_.p()[std::size_t(i)] = double(n.p);
    const double v = product(its_y.data(), z_.data(), u_.size()) + kinematic_part(block, row),
                 c = double(n.c);
    problem_.b()[std::size_t(i)] = v - c;
    scale_ = std::max({scale_, std::fabs(c), std::fabs(v - c)});
}

bool TreeSolve::is_disc(int i) const
{
    const TreeRow& first = rows_[std::size_t(i)];
    if (!system_->blocks[std::size_t(first.block)].coulomb || i + 1 >= int(rows_.size())) return false;
    const TreeRow& next = rows_[std::size_t(i) + 1];
    const auto bounds_friction = [&](const TreeRow& row) {
        const Real hi = system_->numbers[std::size_t(row.source)].hi;
        return hi > 0 && hi < kInf && system_->rows[std::size_t(row.source)].lin1 != Vec3{};
    };
    const auto parent = [&](const TreeRow& row) { return system_->numbers[std::size_t(row.source)].parent; };
    return next.block == first.block && parent(next) == parent(first) && bounds_friction(first) &&
           bounds_friction(next);
}

// The second row is measured by the ratio of the two bounds, so that the disc is round.
void TreeSolve::make_disc(int i)
{
    const auto limit = [&](int row) {
        return double(system_->numbers[std::size_t(rows_[std::size_t(row)].source)].hi);
    };
    problem_.rows()[std::size_t(i)].disc = true, problem_.rows()[std::size_t(i) + 1].second = true;
    const double ratio = limit(i + 1) / limit(i);
    rows_[std::size_t(i) + 1].ratio = ratio;
    if (ratio == 1) return;
    for (int k = 0; k < problem_.size(); ++k)
        problem_.row(i + 1)[k] *= ratio, problem_.row(k)[i + 1] *= ratio;
    for (std::size_t k = 0; k < u_.size(); ++k) y(i + 1)[k] *= ratio;
    problem_.b()[std::size_t(i) + 1] *= ratio, problem_.p()[std::size_t(i) + 1] /= ratio;
}

void TreeSolve::bind_parents()
{
    for (int i = 0; i < int(rows_.size()); ++i) {
        const RowNumbers& n = system_->numbers[std::size_t(rows_[std::size_t(i)].source)];
        if (n.parent < 0) continue;
        FrictionRow& row = problem_.rows()[std::size_t(i)];
        row.parent = row_of_source_[std::size_t(n.parent)];
        if (!row.second && is_disc(i)) make_disc(i);
    }
}

// ODE's two phases (solve/exact/direct.cpp), where friction is a box.
bool TreeSolve::solve_phases()
{
    const std::span<FrictionRow> rows = problem_.rows();
    bool friction = false;
    for (FrictionRow& row : rows)
        if (row.parent >= 0) friction = true;
    if (!friction) return problem_.solve(scale_, kWanted, kPromised);
    const auto bound = [&](bool by_normals) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const RowNumbers& n = system_->numbers[std::size_t(rows_[i].source)];
            if (n.parent < 0) continue;
            const double normal = std::fabs(problem_.p()[std::size_t(row_of_source_[std::size_t(n.parent)])]);
            rows[i].parent = -1;
            rows[i].hi = by_normals && normal > 0 ? double(n.hi) * normal : 0, rows[i].lo = -rows[i].hi;
        }
    };
    bound(false);
    if (!problem_.solve(scale_, kWanted, kPromised)) return false;
    bound(true);
    return problem_.solve(scale_, kWanted, kPromised);
}

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

bool TreeSolve::solve(SolveReport& report)
{
    if (!rows_.empty()) {
        const bool found = system_->coulomb ? problem_.solve(scale_, kPromised, kCoulomb) : solve_phases();
        if (!found) return false;
        report.iterations += problem_.systems();
        report.residual = Real(problem_.residual()), report.friction_error = Real(problem_.friction_error());
    }
    ++report.factorisations;
    std::copy(z_.begin(), z_.end(), u_.begin());
    for (int i = 0; i < int(rows_.size()); ++i) {
        const double p = problem_.p()[std::size_t(i)];
        if (p == 0) continue;
        const double* const its = y(i);
        for (std::size_t k = 0; k < u_.size(); ++k) u_[k] += p * its[k];
    }
    factor_.to_velocities(u_);
    const auto is_usable = [](double x) { return std::fabs(x) < 1e15; };
    if (!std::all_of(u_.begin(), u_.end(), is_usable)) return false;
    std::copy(u_.begin(), u_.end(), solved_.begin());
    store_impulses(), store_yield();
    return true;
}

void TreeSolve::store_velocities()
{
    tree_->velocities(u_, scratch_);
    for (std::size_t i = 0; i < scratch_.size(); ++i) {
        SolverBody& body = system_->bodies[std::size_t(tree_->link(int(i)).body)];
        body.w = scratch_[i].ang, body.v = scratch_[i].lin;
    }
}

void TreeSolve::store_impulses()
{
    for (int i = 0; i < int(rows_.size()); ++i)
        system_->numbers[std::size_t(rows_[std::size_t(i)].source)].p =
            Real(rows_[std::size_t(i)].ratio * problem_.p()[std::size_t(i)]);
}

void TreeSolve::add_yield_impulses(std::span<const double> before, std::span<const double> after)
{
    for (const Yield& yield : yields_) {
        double change = 0;
        for (int i = 0; i < yield.count; ++i) {
            const auto at = std::size_t(yield.first + i);
            change += yield.j[i] * (after[at] - before[at]);
        }
        system_->numbers[std::size_t(yield.source)].p -= Real(change / yield.C);
    }
}

void TreeSolve::store_yield()
{
    for (const Yield& yield : yields_) {
        double rate = 0;
        for (int i = 0; i < yield.count; ++i) rate += yield.j[i] * u_[std::size_t(yield.first + i)];
        system_->numbers[std::size_t(yield.source)].p = Real((yield.c - rate) / yield.C);
    }
}

// Cholesky's factor of A for the rows that act.
bool TreeSolve::prepare_corrections(Arena& arena)
{
    acting_count_ = 0;
    for (int i = 0; i < int(rows_.size()); ++i)
        if (problem_.acts(i)) acting_[std::size_t(acting_count_++)] = i;
    const int n = acting_count_;
    const int all = int(u_.size()) + n;
    acting_factor_ = arena.take<double>(n * n);
    corrected_ = arena.take_zeroed<double>(int(u_.size()));
    correction_ = arena.take<double>(all), step_ = arena.take<double>(all), history_ = 0;
    for (int i = 0; i < kHistory; ++i)
        steps_[i] = arena.take<double>(all), changes_[i] = arena.take<double>(all);
    if (arena.failed()) return false;
    double* const L = acting_factor_.data();
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k <= i; ++k)
            L[i * n + k] = problem_.row(acting_[std::size_t(i)])[acting_[std::size_t(k)]];
        for (int k = 0; k < i; ++k) {
            const double a = (L[i * n + k] - product(L + i * n, L + k * n, std::size_t(k))) / L[k * n + k];
            L[i * n + k] = a;
        }
        const double d = L[i * n + i] - product(L + i * n, L + i * n, std::size_t(i));
        if (!(d > 0)) return false;
        L[i * n + i] = std::sqrt(d);
    }
    return true;
}

// To correction_: z, then dp of the rows that act.
void TreeSolve::find_correction(std::span<double> r)
{
    const int n = acting_count_;
    const double* const L = acting_factor_.data();
    double* const dp = correction_.data() + r.size();
    factor_.to_factor_space(r);
    for (std::size_t k = 0; k < r.size(); ++k) r[k] += corrected_[k];
    for (int i = 0; i < n; ++i) {
        const double w = product(y(acting_[std::size_t(i)]), r.data(), r.size());
        dp[i] = (-w - product(L + i * n, dp, std::size_t(i))) / L[i * n + i];
    }
    for (int i = n; i-- > 0;) {
        double sum = dp[i];
        for (int k = i + 1; k < n; ++k) sum -= L[k * n + i] * dp[k];
        dp[i] = sum / L[i * n + i];
    }
    for (int i = 0; i < n; ++i) {
        const double* const its = y(acting_[std::size_t(i)]);
        for (std::size_t k = 0; k < r.size(); ++k) r[k] += dp[i] * its[k];
    }
    std::copy(r.begin(), r.end(), correction_.begin());
}

// Anderson's: with f the correction and x what is corrected, the step f - sum g (dx + df) with the g that make f - sum g df least, in z,
// the metric of energy.
void TreeSolve::extrapolate()
{
    const std::size_t n = u_.size(), all = correction_.size();
    std::copy(correction_.begin(), correction_.end(), step_.begin());
    if (history_ == 0) return;
    const auto of_z = [&](std::span<const double> a, std::span<const double> b) {
        return product(a.data(), b.data(), n);
    };
    const std::span<double> a = changes_[0], b = changes_[1];
    double g = 0, k = 0;
    const double aa = of_z(a, a), af = of_z(a, correction_);
    if (history_ == 1) {
        if (aa > 0) g = af / aa;
    } else {
        const double bb = of_z(b, b), ab = of_z(a, b), bf = of_z(b, correction_), det = aa * bb - ab * ab;
        constexpr double kIndependent = 1e-8;
        if (det > kIndependent * aa * bb)
            g = (af * bb - bf * ab) / det, k = (bf * aa - af * ab) / det;
        else if (aa > 0)
            g = af / aa;
    }
    for (std::size_t i = 0; i < all; ++i) step_[i] -= g * (steps_[0][i] + a[i]);
    if (k != 0)
        for (std::size_t i = 0; i < all; ++i) step_[i] -= k * (steps_[1][i] + b[i]);
}

double TreeSolve::correct(std::span<double> r)
{
    const std::size_t n = r.size();
    // changes_[0] still holds the last correction; it becomes the change since then.
    find_correction(r);
    if (history_ > 0)
        for (std::size_t i = 0; i < correction_.size(); ++i) changes_[0][i] = correction_[i] - changes_[0][i];
    extrapolate();
    std::swap(steps_[0], steps_[1]), std::swap(changes_[0], changes_[1]);
    std::copy(step_.begin(), step_.end(), steps_[0].begin());
    std::copy(correction_.begin(), correction_.end(), changes_[0].begin());
    history_ = std::min(history_ + 1, kHistory);
    for (int i = 0; i < acting_count_; ++i) {
        const TreeRow& row = rows_[std::size_t(acting_[std::size_t(i)])];
        const double dp = step_[n + std::size_t(i)];
        const double* const its = y(acting_[std::size_t(i)]);
        for (std::size_t k = 0; k < n; ++k) corrected_[k] += dp * its[k];
        system_->numbers[std::size_t(row.source)].p += Real(row.ratio * dp);
    }
    std::copy(step_.begin(), step_.begin() + std::ptrdiff_t(n), r.begin());
    factor_.to_velocities(r);
    double largest = 0;
    for (std::size_t k = 0; k < n; ++k) u_[k] += r[k], largest = std::max(largest, std::fabs(r[k]));
    return largest;
}

void TreeSolve::add_yield(std::span<double> r) const
{
    for (const Yield& yield : yields_) {
        double rate = 0;
        for (int i = 0; i < yield.count; ++i) {
            const auto at = std::size_t(yield.first + i);
            rate += yield.j[i] * (u_[at] - solved_[at]);
        }
        for (int i = 0; i < yield.count; ++i) r[std::size_t(yield.first + i)] -= yield.j[i] * rate / yield.C;
    }
}

void TreeSolve::add_yields_to(TreeFactor& factor) const
{
    for (const Yield& yield : yields_)
        for (int i = 0; i < yield.count; ++i)
            for (int k = 0; k <= i; ++k)
                factor.add(yield.first + i, yield.first + k, yield.j[i] * yield.j[k] / yield.C);
}

void TreeSolve::add_yield_momentum(std::span<const double> rates, std::span<double> g) const
{
    for (const Yield& yield : yields_) {
        double rate = 0;
        for (int i = 0; i < yield.count; ++i) rate += yield.j[i] * rates[std::size_t(yield.first + i)];
        for (int i = 0; i < yield.count; ++i) g[std::size_t(yield.first + i)] += yield.j[i] * rate / yield.C;
    }
}

void TreeSolve::subtract_impulses(std::span<Spatial> of_links) const
{
    const auto subtract = [&](int body, double p, Vec3 lin, Vec3 ang) {
        const int at = tree_->link_of_body(body);
        if (at < 0) return;
        Spatial& to = of_links[std::size_t(at)];
        to = {to.ang - Real(p) * ang, to.lin - Real(p) * lin};
    };
    const auto subtract_row = [&](const RowBlock& block, int source) {
        const Row& row = system_->rows[std::size_t(source)];
        const double p = double(system_->numbers[std::size_t(source)].p);
        if (p == 0) return;
        if (block.term_count > 0)
            for (const WideTerm& term : terms_of(*system_, block)) subtract(term.body, p, term.lin, term.ang);
        else
            subtract(block.body1, p, row.lin1, row.ang1), subtract(block.body2, p, row.lin2, row.ang2);
    };
    for (const RowBlock& block : system_->blocks)
        for (int i = block.first; i < block.first + block.count; ++i)
            if (row_of_source_[std::size_t(i)] >= 0) subtract_row(block, i);
    for (const Yield& yield : yields_)
        for (const RowBlock& block : system_->blocks)
            if (yield.source >= block.first && yield.source < block.first + block.count)
                subtract_row(block, yield.source);
}

void TreeSolve::store_joint_impulses(std::span<const Spatial> impulses)
{
    for (std::size_t i = 0; i < impulses.size(); ++i) {
        const TreeLink& link = tree_->link(int(i));
        if (link.block < 0) continue;
        const RowBlock& block = system_->blocks[std::size_t(link.block)];
        const Row* const rows = &system_->rows[std::size_t(block.first)];
        RowNumbers* const n = &system_->numbers[std::size_t(block.first)];
        const Spatial f = link.is_body1 ? impulses[i] : Real(-1) * impulses[i];  // on body 1
        if (link.joint == LinkJoint::kSlider) {
            Vec3 torque = f.ang;
            for (int k = 3; k < 5; ++k) n[k].p = dot(f.lin, rows[k].lin1), torque -= n[k].p * rows[k].ang1;
            for (int k = 0; k < 3; ++k) n[k].p = torque[k];
            continue;
        }
        for (int k = 0; k < 3; ++k) n[k].p = f.lin[k];
        for (int k = 3; k < lock_rows(link.joint); ++k) n[k].p = dot(f.ang, rows[k].ang1);
    }
}

// minimise dq H dq / 2
bool TreeSolve::least_displacement(std::span<const double> errors, std::span<double> dq, Arena& arena)
{
    Arena::Scope scope(arena);
    int count = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const double e = errors[std::size_t(rows_[i].source)];
        if (e > -double(kInf)) acting_[std::size_t(count++)] = int(i);
    }
    FrictionProblem problem;
    if (!problem.prepare(count, arena)) return false;
    double scale = 0;
    for (int i = 0; i < count; ++i) {
        const int from = acting_[std::size_t(i)], source = rows_[std::size_t(from)].source;
        const RowNumbers& n = system_->numbers[std::size_t(source)];
        for (int k = 0; k < count; ++k) problem.row(i)[k] = problem_.row(from)[acting_[std::size_t(k)]];
        problem.row(i)[i] *= 1 + 1e-9;
        const double e = errors[std::size_t(source)];
        problem.rows()[std::size_t(i)] = {n.lo == 0 ? 0 : -double(kInf), n.hi == 0 ? 0 : double(kInf), -1,
                                          false, false};
        problem.b()[std::size_t(i)] = -e;
        scale = std::max(scale, std::fabs(e));
    }
    if (!(scale > 0) || !problem.solve(scale, 1e-6, 1e-6)) return false;
    std::fill(dq.begin(), dq.end(), 0);
    for (int i = 0; i < count; ++i) {
        const double p = problem.p()[std::size_t(i)];
        const double* const its = y(acting_[std::size_t(i)]);
        for (std::size_t k = 0; k < dq.size(); ++k) dq[k] += p * its[k];
    }
    factor_.to_velocities(dq);
    return true;
}

}  // namespace epode
