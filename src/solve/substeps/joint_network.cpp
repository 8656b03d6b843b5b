// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Padding rows and columns, after the rows of a joint and for rows that are held on a bound, are those of the
// unit matrix with right-hand side zero. Every diagonal element gets a billionth of itself added: redundant
// rows then have a factor, and since each visit starts from the true residual, the next visit recovers the
// digits that this costs.
#include "solve/substeps/joint_network.h"

#include <algorithm>

#include "solve/common/cut_blocks.h"

namespace epode {
namespace {

constexpr int kRounds = 4;                                   // of holding and releasing, per visit
constexpr int kRoundsThatLetGo = 2;                          // of them may release: no two rows alternate
constexpr double kFirm = 1e-9;                               // share of the diagonal
constexpr Real kSlack = kSingle ? Real(1e-5) : Real(1e-10);  // velocity that releases nothing
constexpr int kMaxPartners = 12;                             // couplings per joint, on average
constexpr int kMaxBlocks = 24;                               // of the factor, per joint

double wide_dot(Vec3 a, Vec3 b)
{
    return double(a.x) * double(b.x) + double(a.y) * double(b.y) + double(a.z) * double(b.z);
}

bool moves(const RowSystem& system, int body)
{
    return body >= 0 && system.bodies[std::size_t(body)].inv_mass > 0;
}

}  // namespace

bool JointNetwork::analyse(const RowSystem& system, SymbolicCache* symbolic_cache, Arena& arena)
{
    worth_ = false;
    if (!system.terms.empty()) return true;  // couplings are visited by sweeps
    if (!list_joints(system, arena)) return false;
    if (joints_.empty()) return true;
    if (!list_couplings(system, arena)) return false;
    if (couplings_.size() > kMaxPartners * joints_.size()) return true;
    auto pairs = arena.take<BodyPair>(int(couplings_.size()));
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {couplings_[i].a, couplings_[i].b};
    if (!lease_.take(int(joints_.size()), pairs, symbolic_cache, arena)) return false;
    worth_ = std::size_t(lease_.symbolic().blocks) <= kMaxBlocks * joints_.size();
    return true;
}

bool JointNetwork::list_joints(const RowSystem& system, Arena& arena)
{
    int joints = 0;
    for (const RowBlock& block : system.blocks)
        if (!block.contact) joints += pieces_of(block);
    joints_ = arena.take<NetworkJoint>(joints);
    if (arena.failed()) return false;
    int next = 0, row = 0;
    for (const RowBlock& block : system.blocks) {
        if (block.contact) continue;
        for_each_piece(block, [&](const RowBlock& piece) {
            NetworkJoint& out = joints_[std::size_t(next++)];
            out.first = row, out.count = piece.count, out.source = piece.first;
            out.body[0] = block.body1, out.body[1] = second_slot(system, block.body2);
            out.inv_mass[0] = system.bodies[std::size_t(block.body1)].inv_mass;
            out.inv_mass[1] = block.body2 >= 0 ? system.bodies[std::size_t(block.body2)].inv_mass : 0;
            row += out.count;
        });
    }
    return true;
}

// The joints of each body that moves, side by side, and then every pair of them.
bool JointNetwork::list_couplings(const RowSystem& system, Arena& arena)
{
    const int bodies = int(system.bodies.size());
    auto first = arena.take_zeroed<int>(bodies + 1);
    auto fill = arena.take<int>(bodies);
    auto ends = arena.take<int>(2 * int(joints_.size()));
    if (arena.failed()) return false;
    const auto for_ends = [&](auto&& visit) {
        for (std::size_t j = 0; j < joints_.size(); ++j)
            for (int side = 0; side < 2; ++side)
                if (const int b = joints_[j].body[side]; b < bodies && moves(system, b))
                    visit(b, int(j), side);
    };
    for_ends([&](int b, int, int) { ++first[std::size_t(b) + 1]; });
    std::size_t pairs = 0;
    for (int b = 0; b < bodies; ++b) {
        const auto n = std::size_t(first[std::size_t(b) + 1]);
        pairs += n * (n - 1) / 2;
        first[std::size_t(b) + 1] += first[std::size_t(b)];
        fill[std::size_t(b)] = first[std::size_t(b)];
    }
    const std::size_t limit = kMaxPartners * joints_.size() + 1;  // so many are too many, whichever they are
    couplings_ = arena.take<Coupling>(int(std::min(pairs, limit)));
    if (arena.failed()) return false;
    for_ends([&](int b, int j, int side) { ends[std::size_t(fill[std::size_t(b)]++)] = 2 * j + side; });
    std::size_t next = 0;
    for (int b = 0; b < bodies; ++b)
        for (int i = first[std::size_t(b)]; i < first[std::size_t(b) + 1]; ++i)
            for (int k = first[std::size_t(b)]; k < i && next < couplings_.size(); ++k) {
                const int p = ends[std::size_t(i)], q = ends[std::size_t(k)];
                couplings_[next++] = {p / 2, q / 2, p % 2, q % 2, nullptr, false};
            }
    return true;
}

bool JointNetwork::pack(const RowSystem& system, Arena& arena)
{
    int rows = 0;
    for (const NetworkJoint& joint : joints_) rows += joint.count;
    rows_ = arena.take<NetworkRow>(rows);
    x_ = arena.take<double>(6 * int(joints_.size()));
    if (arena.failed() || !A_.prepare(lease_.symbolic(), Tasks(1), arena)) return false;
    for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].diagonal = A_.diagonal(int(j));
    for (Coupling& c : couplings_)
        if (c.a != c.b) c.block = A_.between(c.a, c.b, c.transposed);
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
    row.hold = Hold::kFree;
    bounded_ = bounded_ || n.parent >= 0 || n.bounded();
    if (n.parent >= 0 || !n.bounded()) return;
    // Rows that the last step left on a bound will probably be there again.
    if (row.p <= row.lo) row.hold = Hold::kLow;
    if (row.p >= row.hi) row.hold = Hold::kHigh;
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
    const RowAim aim = map_row(row, step, inverse_effective_mass(row, a, b));
    out.C = aim.C;
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
    stale_ = true;
}

void JointNetwork::fill_diagonal(const NetworkJoint& joint)
{
    const auto rows = rows_of(joint);
    double* const D = joint.diagonal;
    for (int i = 0; i < 6; ++i) D[7 * i] = 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].hold != Hold::kFree) continue;
        for (std::size_t j = 0; j <= i; ++j) {
            if (rows[j].hold != Hold::kFree) continue;
            double sum = 0;
            for (int side = 0; side < 2; ++side)
                sum += double(joint.inv_mass[side]) * wide_dot(rows[i].lin[side], rows[j].lin[side]) +
                       wide_dot(rows[i].ang[side], rows[j].turn[side]);
            D[6 * j + i] = sum;
        }
        double& d = D[7 * i];
        d += kFirm * d + double(rows[i].C);
        if (!(d > 0)) d = 1;
    }
}

void JointNetwork::fill_coupling(const Coupling& c)
{
    // A joint of a body with itself has no effect.
    if (c.a == c.b) return;
    const NetworkJoint& a = joints_[std::size_t(c.a)];
    const auto rows_a = rows_of(a), rows_b = rows_of(joints_[std::size_t(c.b)]);
    const auto inv_mass = double(a.inv_mass[c.side_a]);
    for (std::size_t i = 0; i < rows_a.size(); ++i) {
        if (rows_a[i].hold != Hold::kFree) continue;
        for (std::size_t j = 0; j < rows_b.size(); ++j) {
            if (rows_b[j].hold != Hold::kFree) continue;
            const double sum = inv_mass * wide_dot(rows_a[i].lin[c.side_a], rows_b[j].lin[c.side_b]) +
                               wide_dot(rows_a[i].ang[c.side_a], rows_b[j].turn[c.side_b]);
            c.block[c.transposed ? 6 * i + j : 6 * j + i] += sum;
        }
    }
}

void JointNetwork::factor()
{
    A_.clear();
    for (const NetworkJoint& joint : joints_) fill_diagonal(joint);
    for (const Coupling& coupling : couplings_) fill_coupling(coupling);
    (void)A_.factor();
    ++factorisations_;
    stale_ = false;
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

Real JointNetwork::bound(const NetworkRow& row) const
{
    Real lo, hi;
    bounds(row, lo, hi);
    return row.hold == Hold::kLow ? lo : hi;
}

void JointNetwork::put_on_bounds(std::span<Velocity> bodies)
{
    for (const NetworkJoint& joint : joints_)
        for (NetworkRow& row : rows_of(joint)) {
            if (row.hold == Hold::kFree) continue;
            const Real dp = bound(row) - row.p;
            if (dp != 0) apply(row, joint, dp, bodies);
            row.p += dp;
        }
}

void JointNetwork::solve_free(std::span<Velocity> bodies, bool relax)
{
    if (stale_) factor();
    std::fill(x_.begin(), x_.end(), 0.0);
    double* x = x_.data();
    for (const NetworkJoint& joint : joints_) {
        for (std::size_t i = 0; const NetworkRow& row : rows_of(joint)) {
            if (row.hold == Hold::kFree)
                x[i] = double((relax ? row.c_relaxed : row.c) - velocity(row, joint, bodies) - row.C * row.p);
            ++i;
        }
        x += 6;
    }
    A_.solve(x_);
    x = x_.data();
    for (const NetworkJoint& joint : joints_) {
        for (std::size_t i = 0; NetworkRow & row : rows_of(joint)) {
            const Real dp = row.hold == Hold::kFree ? Real(x[i]) : 0;
            row.p += dp;
            apply(row, joint, dp, bodies);
            ++i;
        }
        x += 6;
    }
}

// True: some rows changed between held and free.
bool JointNetwork::change_holds(std::span<Velocity> bodies, bool relax, bool may_let_go)
{
    bool changed = false;
    for (const NetworkJoint& joint : joints_)
        for (NetworkRow& row : rows_of(joint)) {
            Real lo, hi;
            bounds(row, lo, hi);
            const Hold before = row.hold;
            if (row.hold == Hold::kFree) {
                if (row.p < lo) row.hold = Hold::kLow;
                if (row.p > hi) row.hold = Hold::kHigh;
            } else if (may_let_go && lo < hi) {
                const Real w = velocity(row, joint, bodies) + row.C * row.p - (relax ? row.c_relaxed : row.c);
                if (row.hold == Hold::kLow ? w < -kSlack : w > kSlack) row.hold = Hold::kFree;
            }
            changed = changed || row.hold != before;
        }
    stale_ = stale_ || changed;
    return changed;
}

void JointNetwork::sweep(std::span<Velocity> bodies, const JointSweep& how)
{
    const bool relax = how.relax;
    for (int round = 0; round < kRounds; ++round) {
        if (bounded_) put_on_bounds(bodies);
        solve_free(bodies, relax);
        if (!bounded_ || !change_holds(bodies, relax, round < kRoundsThatLetGo)) return;
    }
    put_on_bounds(bodies);  // the next visit does the rest
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
            mine.c_relaxed = row.restitution_velocity;
            any = true;
        }
    if (any) sweep(bodies, {1, true});
}

}  // namespace epode
