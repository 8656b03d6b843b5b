// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/tree/tree_motion.h"

#include <algorithm>
#include <cmath>

#include "dynamics/exact_spin.h"
#include "step/island/positions/free_momentum.h"
#include "step/island/positions/position_rows.h"
#include "step/island/positions/solved_motion.h"

namespace epode {
namespace {

constexpr Real kLongestTurn = 2;  // rad in a step, up to which the turn of a free flight is exact
constexpr int kMaxIterations = 24;
constexpr double kEnough = kSingle ? 1e-6 : 1e-10;  // rad and m, of a correction that is left out
constexpr double kSlow = 0.9;                       // times the last correction: it converges no more
constexpr Real kLongestOpening =
    Real(0.02);  // of a loop's joint in a step, relative to its lever, as in shake.cpp

}  // namespace

bool TreeMotion::begin(const World& world, IslandWork& work, JointTree& tree, TreeSolve& solve,
                       ClosingRows& closing, Arena& arena)
{
    world_ = &world, work_ = &work, tree_ = &tree, solve_ = &solve, closing_ = &closing, arena_ = &arena;
    size_ = tree.links().size();
    const int links = int(size_), n = tree.dofs();
    before_ = arena.take<Spatial>(links), bias_ = arena.take<Spatial>(links);
    path_ = arena.take<Spatial>(links), momenta_ = arena.take<Spatial>(links);
    scratch_ = arena.take<Spatial>(links), impulses_ = arena.take<Spatial>(links);
    momentum_ = arena.take<double>(n), r_ = arena.take<double>(n), dq_ = arena.take<double>(n);
    if (arena.failed() || !poses_.begin(work, tree, arena)) return false;
    find_rates(r_);
    measure_momenta(r_);
    tree.velocities(r_, scratch_);
    for (std::size_t i = 0; i < size_; ++i) {
        SolverBody& b = solver_body(i);
        before_[i] = {b.inertia * b.w, b.mass * b.v};
        bias_[i] = momenta_[i] - Spatial{b.inertia * scratch_[i].ang, b.mass * scratch_[i].lin};
        b.v -= b.inv_mass * bias_[i].lin, b.w -= b.inv_inertia * bias_[i].ang;
    }
    return true;
}

Spatial TreeMotion::momentum_of(std::size_t link, const Spatial& v) const
{
    const SolverBody& b = solver_body(link);
    return {spin_momentum(b.inertia, v.ang, work_->system.h), b.mass * v.lin};
}

void TreeMotion::measure_momenta(std::span<const double> u)
{
    const Real h = work_->system.h;
    too_long_ = false;
    for (std::size_t k = 0; k < dq_.size(); ++k) dq_[k] = double(h) * u[k];
    poses_.go(dq_);
    for (std::size_t i = 0; i < size_; ++i) {
        const Spatial way = poses_.displacement(int(i));
        too_long_ |= !(length2(way.ang) < kLongestTurn * kLongestTurn);
        path_[i] = (1 / h) * way;
        momenta_[i] = momentum_of(i, path_[i]);
    }
}

bool TreeMotion::find_way()
{
    tree_->velocities(solve_->u(), scratch_);
    for (std::size_t i = 0; i < size_; ++i) {
        const SolverBody& b = solver_body(i);
        scratch_[i] = bias_[i] + Spatial{b.inertia * scratch_[i].ang, b.mass * scratch_[i].lin};
    }
    tree_->gather(scratch_, momentum_);
    if (!solve_->prepare_corrections(*arena_)) return false;
    closing_->expect();
    if (iterate() && !is_thrown_by_closing()) return true;
    closing_->restore_poses();
    return false;
}

bool TreeMotion::iterate()
{
    // The gaps of loops have no more digits than the places of their anchors.
    const double enough = closing_->none() ? kEnough : std::max(kEnough, double(closing_->rounding()));
    double last = double(kInf);
    for (int pass = 0; pass < kMaxIterations; ++pass) {
        measure_momenta(solve_->u());
        if (too_long_) return false;
        if (!closing_->none() && !(closing_->measure(poses_, *solve_) <= kLongestOpening)) return false;
        std::copy(momenta_.begin(), momenta_.end(), scratch_.begin());
        tree_->gather(scratch_, r_);
        for (std::size_t k = 0; k < r_.size(); ++k) r_[k] = momentum_[k] - r_[k];
        solve_->add_yield(r_);
        const double now = solve_->correct(r_) * double(work_->system.h);
        const double next = pass == 0 ? now : now * std::min(now / last, 1.0);
        if (next <= enough) break;
        if (pass > 3 && now > kSlow * last) return false;
        last = now;
    }
    measure_momenta(solve_->u());
    solve_->store_yield();
    keep_momentum();
    find_joint_impulses();
    for (std::size_t i = 0; i < size_; ++i) solver_body(i).v = path_[i].lin, solver_body(i).w = path_[i].ang;
    return !too_long_;
}

// Near a dead centre levers would have to fly to close a loop.
bool TreeMotion::is_thrown_by_closing()
{
    if (closing_->none()) return false;
    SolvedMotion solved, closed;
    tree_->velocities(solve_->solution(), scratch_);
    for (std::size_t i = 0; i < size_; ++i) {
        const SolverBody& b = solver_body(i);
        const auto energy = [&](const Spatial& v) {
            return 0.5 * double(b.mass * length2(v.lin) + dot(v.ang, b.inertia * v.ang));
        };
        solved.energy += energy(scratch_[i]), solved.mass += double(b.mass),
            closed.energy += energy(path_[i]);
    }
    return is_thrown(solved, closed);
}

void TreeMotion::advance()
{
    poses_.go_and_close(dq_);
    store_poses();
}

// Of free trees on nothing: what the iteration has left of it. Trees of one island are held together by rows.
void TreeMotion::keep_momentum()
{
    const auto is_inner = [&](const RowBlock& b) {
        return !b.contact && b.term_count == 0 && tree_->link_of_body(b.body1) >= 0 &&
               tree_->link_of_body(b.body2) >= 0;
    };
    if (!std::all_of(work_->system.blocks.begin(), work_->system.blocks.end(), is_inner)) return;
    Real mass = 0;
    Vec3 lost;
    for (std::size_t i = 0; i < size_; ++i)
        mass += solver_body(i).mass, lost += before_[i].lin - momenta_[i].lin;
    const Vec3 dv = (1 / mass) * lost;
    for (std::size_t i = 0; i < size_; ++i) {
        momenta_[i].lin += solver_body(i).mass * dv, path_[i].lin += dv;
        const TreeLink& its = tree_->link(int(i));
        if (its.joint != LinkJoint::kFree) continue;
        for (int k = 0; k < 3; ++k) dq_[std::size_t(its.first + k)] += double(work_->system.h * dv[k]);
        solve_->add_to_root(its, dv);
    }
}

void TreeMotion::store_poses() const
{
    for (std::size_t i = 0; i < size_; ++i) poses_.store(int(i), body(i));
}

// What is left of a row's error where the step ends, to first order in its motion; as in projection.cpp.
Real TreeMotion::gap(const RowBlock& block, const Row& row, std::size_t k) const
{
    Real e = row.error - work_->system.h * row_velocity(work_->system, block, row, work_->system.bodies);
    if (row.kind == RowKind::kNormal && k >= work_->joints.size())
        e += work_->system.h * std::min(row.speed, Real(0));
    return e;
}

Real TreeMotion::find_gaps(std::span<double> errors) const
{
    std::fill(errors.begin(), errors.end(), -double(kInf));
    Real worst = closing_->find_gaps(errors);
    const RowSystem& system = work_->system;
    for (std::size_t k = 0; k < system.blocks.size(); ++k) {
        const RowBlock& block = system.blocks[k];
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = system.rows[std::size_t(i)];
            if ((row.lo != 0 && row.hi != 0) || row.kind == RowKind::kFriction) continue;
            Real e = gap(block, row, k);
            const Real sign = row.lo == 0 ? Real(1) : Real(-1);
            const Real near = system.h * Real(10);
            if (sign * e < -near || is_spring(row, block, system)) continue;
            Real per_arm = 1;
            if (!turns_only(row)) per_arm = 1 / longest_arm(*work_, block);
            if (row.kind == RowKind::kNormal) {
                e -= world_->projection_tolerance / 2 / per_arm;
                const Real share = std::min(row.erp, Real(1));
                if (e > 0 && share > 0) e *= share, per_arm /= share;
                if (!(share > 0)) e = std::min(e, Real(0));
            }
            errors[std::size_t(i)] = double(e);
            worst = std::max(worst, sign * e * per_arm);
        }
    }
    return worst;
}

ProjectionReport TreeMotion::project()
{
    ProjectionReport report;
    Arena::Scope scope(*arena_);
    const auto errors = arena_->take<double>(int(work_->system.rows.size()));
    if (arena_->failed()) return report;
    const Real worst = find_gaps(errors);
    report.error = double(worst);
    if (!(worst > world_->projection_tolerance)) return report;
    const double h = double(work_->system.h);
    if (!solve_->least_displacement(errors, dq_, *arena_)) return report;
    for (std::size_t k = 0; k < dq_.size(); ++k) dq_[k] += h * solve_->u()[k];
    for (std::size_t i = 0; i < size_; ++i)
        store(body(i).lvel, path_[i].lin), store(body(i).avel, path_[i].ang);
    const FreeMomentum momentum(*work_);
    poses_.go_and_close(dq_);
    store_poses();
    momentum.restore();
    for (std::size_t i = 0; i < size_; ++i) {
        const SolverBody& b = solver_body(i);
        momenta_[i].lin += b.mass * (body(i).velocity() - path_[i].lin);
        momenta_[i].ang += b.inertia * (body(i).angular_velocity() - path_[i].ang);
    }
    report.iterations = 1, report.error = double(world_->projection_tolerance);
    return report;
}

}  // namespace epode
