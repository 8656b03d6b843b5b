// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/substeps/joint_network.h"

#include <algorithm>

#include "solve/common/cut_blocks.h"

namespace epode {
namespace {

constexpr int kRounds = 4;                                   // of solving and changing places, per visit
constexpr int kRoundsThatRelease = 2;                        // of them may release: no two rows alternate
constexpr Real kSlack = kSingle ? Real(1e-5) : Real(1e-10);  // velocity that releases nothing

// A stop, as against friction and drives of limited force.
bool is_one_sided(const NetworkRow& row) { return row.parent < 0 && !(row.lo > -kInf && row.hi < kInf); }

}  // namespace

bool JointNetwork::analyse(const RowSystem& system, SymbolicCache* symbolic_cache, Arena& arena)
{
    worth_ = false;
    system_ = &system;
    if (!system.terms.empty()) return true;  // couplings are visited by sweeps
    if (!list_joints(system, JointForest::kMaxRows, arena)) return false;
    if (joints_.empty()) return true;
    if (!forest_.build(system, joints_, arena)) return false;
    if (forest_.is_forest()) return sort_joints(arena);
    groups_ = arena.take<Group>(1);
    if (!list_joints(system, JointLoops::kMaxRows, arena)) return false;
    if (!loops_.build(system, joints_, symbolic_cache, arena)) return false;
    groups_.front() = {0, int(joints_.size()), true};
    worth_ = loops_.worth();
    return true;
}

// Joints in the order of the forest, a group for each bundle.
bool JointNetwork::sort_joints(Arena& arena)
{
    const std::span<NetworkJoint> sorted = arena.take<NetworkJoint>(int(joints_.size()));
    groups_ = arena.take<Group>(int(forest_.bundles().size()));
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = joints_[std::size_t(forest_.order()[i])];
    joints_ = sorted;
    for (std::size_t i = 0; i < groups_.size(); ++i)
        groups_[i] = {forest_.bundles()[i].first, forest_.bundles()[i].last, true};
    worth_ = true;
    return true;
}

bool JointNetwork::list_joints(const RowSystem& system, int most_rows, Arena& arena)
{
    int pieces = 0;
    for (const RowBlock& block : system.blocks)
        if (!block.contact) pieces += pieces_of(block);
    joints_ = arena.take<NetworkJoint>(pieces);
    if (arena.failed()) return false;
    std::size_t count = 0;
    for (const RowBlock& block : system.blocks) {
        if (block.contact) continue;
        for_each_piece(block, [&](const RowBlock& piece) {
            if (count == 0 || !extend(joints_[count - 1], piece, system, most_rows))
                joints_[count++] = network_joint(piece, system);
        });
    }
    joints_ = joints_.first(count);
    return true;
}

NetworkJoint JointNetwork::network_joint(const RowBlock& piece, const RowSystem& system)
{
    NetworkJoint joint{};
    joint.source = piece.first, joint.count = piece.count;
    joint.body[0] = piece.body1, joint.body[1] = second_slot(system, piece.body2);
    joint.inv_mass[0] = system.bodies[std::size_t(piece.body1)].inv_mass;
    joint.inv_mass[1] = piece.body2 >= 0 ? system.bodies[std::size_t(piece.body2)].inv_mass : 0;
    return joint;
}

// A ball joint and the motor that limits it are one block, a quarter of the work of two.
bool JointNetwork::extend(NetworkJoint& joint, const RowBlock& piece, const RowSystem& system, int most_rows)
{
    const bool same = joint.body[0] == piece.body1 && joint.body[1] == second_slot(system, piece.body2);
    if (!same || joint.source + joint.count != piece.first || joint.count + piece.count > most_rows)
        return false;
    joint.count += piece.count;
    return true;
}

bool JointNetwork::pack(const RowSystem& system, Arena& arena)
{
    int rows = 0;
    for (NetworkJoint& joint : joints_) joint.first = rows, rows += joint.count;
    rows_ = arena.take<NetworkRow>(rows);
    x_ = arena.take<double>(rows);
    if (arena.failed()) return false;
    if (!(forest_.is_forest() ? forest_.prepare(joints_, arena) : loops_.prepare(joints_, arena)))
        return false;
    for (const NetworkJoint& joint : joints_)
        for (int i = 0; i < joint.count; ++i)
            pack_row(system.numbers[std::size_t(joint.source + i)], joint,
                     rows_[std::size_t(joint.first + i)]);
    return true;
}

void JointNetwork::pack_row(const RowNumbers& n, const NetworkJoint& joint, NetworkRow& row)
{
    row.lo = n.lo, row.hi = n.hi, row.p = n.p, row.sum = 0;
    row.parent = n.parent >= 0 ? n.parent - joint.source + joint.first : -1;
    row.place = RowPlace::kFactor;
    bounded_ = bounded_ || n.parent >= 0 || n.bounded();
    // Rows that the last step left on a bound will probably be there again.
    if (n.parent < 0 && n.bounded() && (row.p <= row.lo || row.p >= row.hi))
        row.place = is_one_sided(row) ? RowPlace::kHeld : RowPlace::kSwept;
}

void JointNetwork::load_row(const Row& row, const SolverBody* const (&bodies)[2], const Substep& step,
                            NetworkRow& out) const
{
    const SolverBody &a = *bodies[0], *b = bodies[1];
    out.lin[0] = row.lin1, out.ang[0] = row.ang1;
    out.turn[0] = a.inv_inertia * row.ang1;
    out.lin[1] = b ? row.lin2 : Vec3{};
    out.ang[1] = b ? row.ang2 : Vec3{};
    out.turn[1] = b ? b->inv_inertia * row.ang2 : Vec3{};
    const Real inverse_mass = inverse_effective_mass(row, a, b);
    const RowAim aim = map_row(row, step, inverse_mass);
    out.C = aim.C;
    out.step = inverse_mass + aim.C > 0 ? 1 / (inverse_mass + aim.C) : 0;
    out.c = std::min(aim.rate * row.error + target_speed(row, step), row.cap);
    out.c_relaxed = aim.spring ? out.c : std::min(row.speed, row.cap);
}

void JointNetwork::load_substep(const RowSystem& system, const Substep& step)
{
    const auto body = [&](int slot) {
        return std::size_t(slot) < system.bodies.size() ? &system.bodies[std::size_t(slot)] : nullptr;
    };
    for (const NetworkJoint& joint : joints_) {
        const SolverBody* const pair[2] = {body(joint.body[0]), body(joint.body[1])};
        for (int i = 0; i < joint.count; ++i)
            load_row(system.rows[std::size_t(joint.source + i)], pair, step,
                     rows_[std::size_t(joint.first + i)]);
    }
    for (Group& group : groups_) group.stale = true;
}

void JointNetwork::factor(std::size_t group)
{
    if (forest_.is_forest())
        forest_.factor(*system_, group, joints_, rows_);
    else
        loops_.factor(joints_, rows_);
    groups_[group].stale = false;
    factored_ += groups_[group].last - groups_[group].first;
}

int JointNetwork::factorisations() const
{
    const int joints = int(joints_.size());
    return joints > 0 ? (factored_ + joints - 1) / joints : 0;
}

Real JointNetwork::velocity(const NetworkRow& r, const NetworkJoint& joint, std::span<const Velocity> bodies)
{
    const Velocity &a = bodies[std::size_t(joint.body[0])], &b = bodies[std::size_t(joint.body[1])];
    return (dot(r.lin[0], a.v) + dot(r.ang[0], a.w)) + (dot(r.lin[1], b.v) + dot(r.ang[1], b.w));
}

void JointNetwork::apply(const NetworkRow& r, const NetworkJoint& joint, Real dp, std::span<Velocity> bodies)
{
    for (int side = 0; side < 2; ++side) {
        Velocity& body = bodies[std::size_t(joint.body[side])];
        body.v += (joint.inv_mass[side] * dp) * r.lin[side];
        body.w += dp * r.turn[side];
    }
}

void JointNetwork::apply_impulses(std::span<Velocity> bodies) const
{
    for (const NetworkJoint& joint : joints_)
        for (const NetworkRow& row : rows_of(joint)) apply(row, joint, row.p, bodies);
}

void JointNetwork::bounds(const NetworkRow& row, Real& lo, Real& hi) const
{
    lo = row.lo, hi = row.hi;
    if (row.parent < 0) return;
    const Real load = std::fabs(rows_[std::size_t(row.parent)].p);
    hi = load > 0 ? row.hi * load : 0;
    lo = -hi;
}

void JointNetwork::sweep_rows(Group& group, std::span<Velocity> bodies, bool relax)
{
    for (const NetworkJoint& joint : joints_of(group))
        for (NetworkRow& row : rows_of(joint)) {
            if (row.place == RowPlace::kFactor || row.place == RowPlace::kHeld) continue;
            const Real w = velocity(row, joint, bodies) + row.C * row.p - (relax ? row.c_relaxed : row.c);
            Real lo, hi;
            bounds(row, lo, hi);
            const Real dp = std::clamp(row.p - row.step * w, lo, std::max(lo, hi)) - row.p;
            if (dp != 0) apply(row, joint, dp, bodies);
            row.p += dp;
            if (row.place == RowPlace::kSwept && lo < row.p && row.p < hi)
                row.place = RowPlace::kFactor, group.stale = true;
        }
}

void JointNetwork::solve(std::size_t group, std::span<Velocity> bodies, bool relax)
{
    const std::span<const NetworkJoint> joints = joints_of(groups_[group]);
    if (groups_[group].stale) factor(group);
    for (const NetworkJoint& joint : joints)
        for (int i = joint.first; i < joint.first + joint.count; ++i) {
            const NetworkRow& row = rows_[std::size_t(i)];
            if (row.place != RowPlace::kFactor) continue;
            const Real c = relax ? row.c_relaxed : row.c;
            x_[std::size_t(i)] = double(c - velocity(row, joint, bodies) - row.C * row.p);
        }
    if (forest_.is_forest())
        forest_.solve(group, joints_, x_);
    else
        loops_.solve(joints_, rows_, x_);
    for (const NetworkJoint& joint : joints)
        for (int i = joint.first; i < joint.first + joint.count; ++i) {
            NetworkRow& row = rows_[std::size_t(i)];
            if (row.place != RowPlace::kFactor) continue;
            row.p += Real(x_[std::size_t(i)]);
            apply(row, joint, Real(x_[std::size_t(i)]), bodies);
        }
}

// Rows whose impulses are beyond a bound go there and leave the factor. True: there were any.
bool JointNetwork::leave_factor(Group& group, std::span<Velocity> bodies)
{
    bool any = false;
    for (const NetworkJoint& joint : joints_of(group))
        for (NetworkRow& row : rows_of(joint)) {
            if (row.place != RowPlace::kFactor) continue;
            Real lo, hi;
            bounds(row, lo, hi);
            const Real p = std::clamp(row.p, lo, std::max(lo, hi));
            if (p == row.p) continue;
            apply(row, joint, p - row.p, bodies);
            row.p = p, row.place = is_one_sided(row) ? RowPlace::kHeld : RowPlace::kLeft;
            any = true;
        }
    return any;
}

// Held rows that pull away from their bounds go into the factor. True: there were any.
bool JointNetwork::release(Group& group, std::span<const Velocity> bodies, bool relax)
{
    bool any = false;
    for (const NetworkJoint& joint : joints_of(group))
        for (NetworkRow& row : rows_of(joint)) {
            if (row.place != RowPlace::kHeld) continue;
            const Real w = velocity(row, joint, bodies) + row.C * row.p - (relax ? row.c_relaxed : row.c);
            if (!(row.p <= row.lo ? w < -kSlack : w > kSlack)) continue;
            row.place = RowPlace::kFactor;
            any = true;
        }
    return any;
}

void JointNetwork::visit(std::size_t group, std::span<Velocity> bodies, bool relax)
{
    Group& its = groups_[group];
    if (bounded_) sweep_rows(its, bodies, relax);
    for (int round = 0; round < kRounds; ++round) {
        solve(group, bodies, relax);
        if (!bounded_) return;
        const bool left = leave_factor(its, bodies);
        const bool released = round < kRoundsThatRelease && release(its, bodies, relax);
        if (!left && !released) return;
        its.stale = true;
    }
}

void JointNetwork::sweep(std::span<Velocity> bodies, const JointSweep& how)
{
    for (std::size_t group = 0; group < groups_.size(); ++group) visit(group, bodies, how.relax);
}

void JointNetwork::sum_impulses()
{
    for (NetworkRow& row : rows_) row.sum += row.p;
}

void JointNetwork::store_sums(std::span<RowNumbers> numbers) const
{
    for (const NetworkJoint& joint : joints_)
        for (int i = 0; i < joint.count; ++i)
            numbers[std::size_t(joint.source + i)].p = rows_[std::size_t(joint.first + i)].sum;
}

void JointNetwork::describe(std::span<RowNumbers> numbers, std::span<Row>) const
{
    for (const NetworkJoint& joint : joints_)
        for (int i = 0; i < joint.count; ++i) {
            const NetworkRow& row = rows_[std::size_t(joint.first + i)];
            RowNumbers& n = numbers[std::size_t(joint.source + i)];
            n.c = row.c, n.C = row.C, n.p = row.p;
        }
}

void JointNetwork::apply_restitution(const RowSystem& system, std::span<Velocity> bodies)
{
    bool any = false;
    for (const NetworkJoint& joint : joints_)
        for (int i = 0; i < joint.count; ++i) {
            const Row& row = system.rows[std::size_t(joint.source + i)];
            NetworkRow& mine = rows_[std::size_t(joint.first + i)];
            if (!row.has_restitution || mine.sum + mine.p == 0) continue;
            mine.c_relaxed = row.restitution_velocity, mine.place = RowPlace::kFactor;
            any = true;
        }
    if (!any) return;
    for (Group& group : groups_) group.stale = true;
    sweep(bodies, {1, true});
}

}  // namespace epode
