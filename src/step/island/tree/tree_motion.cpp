// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/tree/tree_motion.h"

#include <algorithm>
#include <cmath>

#include "step/island/positions/free_momentum.h"
#include "step/island/positions/position_rows.h"

namespace epode {
namespace {

constexpr int kMaxIterations = 8;
constexpr double kEnough = 1e-7;           // rad and m, of a correction of the displacement
constexpr Real kLongestTurn = Real(0.02);  // opening relative to the lever, about (w h)^2/2
constexpr double kLongest = 0.5;           // times the last correction, that the next one must not exceed

}  // namespace

bool TreeMotion::begin(const World& world, IslandWork& work, JointTree& tree, TreeSolve& solve, Arena& arena)
{
    world_ = &world, work_ = &work, tree_ = &tree, solve_ = &solve, arena_ = &arena;
    size_ = tree.links().size();
    const int links = int(size_), n = tree.dofs();
    before_ = arena.take<Spatial>(links), path_ = arena.take<Spatial>(links);
    scratch_ = arena.take<Spatial>(links), impulses_ = arena.take<Spatial>(links);
    momentum_ = arena.take<double>(n), r_ = arena.take<double>(n), dq_ = arena.take<double>(n);
    if (arena.failed() || !poses_.begin(work, tree, arena)) return false;
    for (std::size_t i = 0; i < size_; ++i) before_[i] = {solver_body(i).w, solver_body(i).v};
    return true;
}

void TreeMotion::measure_path()
{
    const double h = double(work_->system.h);
    for (std::size_t k = 0; k < dq_.size(); ++k) dq_[k] = h * solve_->u()[k];
    poses_.go(dq_);
    for (std::size_t i = 0; i < size_; ++i) path_[i] = (1 / work_->system.h) * poses_.displacement(int(i));
}

// T^T M v
void TreeMotion::gather_momentum(std::span<const Spatial> velocities, std::span<double> out)
{
    for (std::size_t i = 0; i < size_; ++i) {
        const SolverBody& b = solver_body(i);
        scratch_[i] = {b.inertia * velocities[i].ang, b.mass * velocities[i].lin};
    }
    tree_->gather(scratch_, out);
}

bool TreeMotion::advance(bool is_raised)
{
    solve_->store_velocities();
    for (std::size_t i = 0; i < size_; ++i) path_[i] = {solver_body(i).w, solver_body(i).v};
    gather_momentum(path_, momentum_);
    measure_path();
    const bool corrects = solve_->prepare_corrections(*arena_);
    if (arena_->failed()) return false;
    if (!is_raised && !is_too_long() && corrects && iterate()) {
        keep_momentum();
        for (std::size_t i = 0; i < size_; ++i)
            solver_body(i).w = path_[i].ang, solver_body(i).v = path_[i].lin;
    } else {
        fly();
    }
    solve_->store_yield();
    find_joint_impulses();
    store_poses();
    return true;
}

// A link's end would open by more than that share of its lever if bodies flew h v.
bool TreeMotion::is_too_long() const
{
    const Real h = work_->system.h;
    Real largest = 0;
    for (std::size_t i = 0; i < size_; ++i)
        if (tree_->link(int(i)).joint != LinkJoint::kFree || tree_->links().size() > 1)
            largest = std::max(largest, length2(solver_body(i).w));
    return h * h * largest / 2 > kLongestTurn;
}

// The velocities of the solution, of which the next step takes what does not fit its poses: the step is too long for the motion.
void TreeMotion::fly()
{
    solve_->forget_corrections();
    measure_path();
    for (std::size_t i = 0; i < size_; ++i)
        store(body(i).lvel, solver_body(i).v), store(body(i).avel, solver_body(i).w);
    const FreeMomentum momentum(*work_);
    store_poses();
    momentum.restore();
}

// False: it does not converge.
bool TreeMotion::iterate()
{
    double last = double(kInf);
    for (int pass = 0; pass < kMaxIterations; ++pass) {
        gather_momentum(path_, r_);
        for (std::size_t k = 0; k < r_.size(); ++k) r_[k] = momentum_[k] - r_[k];
        solve_->add_yield(r_);
        solve_->correct(r_);
        measure_path();
        double largest = 0;
        for (const double du : r_) largest = std::max(largest, std::fabs(du));
        const double now = largest * double(work_->system.h);
        if (now <= kEnough) return true;
        if (now > kLongest * last) return false;
        last = now;
    }
    return true;
}

// Of free trees on nothing: what the iteration has left of it.
void TreeMotion::keep_momentum()
{
    const auto is_inner = [](const RowBlock& b) { return !b.contact && b.term_count == 0 && b.body2 >= 0; };
    if (!std::all_of(work_->system.blocks.begin(), work_->system.blocks.end(), is_inner)) return;
    const Real h = work_->system.h;
    for (std::size_t root = 0; root < size_; ++root) {
        if (tree_->link(int(root)).joint != LinkJoint::kFree) continue;
        Real mass = 0;
        Vec3 lost;
        const auto for_its = [&](auto&& use) {
            for (std::size_t i = root; i < size_; ++i)
                if (tree_->link(int(i)).root == int(root)) use(i);
        };
        for_its([&](std::size_t i) {
            mass += solver_body(i).mass, lost += solver_body(i).mass * (solver_body(i).v - path_[i].lin);
        });
        const Vec3 dv = (1 / mass) * lost;
        for_its([&](std::size_t i) { path_[i].lin += dv, poses_.shift(int(i), h * dv); });
        solve_->add_to_root(tree_->link(int(root)), dv);
    }
}

void TreeMotion::store_poses() const
{
    for (std::size_t i = 0; i < size_; ++i) {
        Body& b = body(i);
        store(b.pos, poses_.position(int(i))), store_quat(b.q, poses_.orientation(int(i)));
        store_mat(b.R, poses_.rotation(int(i)));
    }
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
    Real worst = 0;
    std::fill(errors.begin(), errors.end(), -double(kInf));
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
    poses_.go(dq_);
    store_poses();
    momentum.restore();
    for (std::size_t i = 0; i < size_; ++i)
        solver_body(i).v = body(i).velocity(), solver_body(i).w = body(i).angular_velocity();
    report.iterations = 1, report.error = double(world_->projection_tolerance);
    return report;
}

}  // namespace epode
