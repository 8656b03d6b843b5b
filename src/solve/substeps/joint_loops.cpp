// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Padding rows and columns, after the rows of a joint and for rows out of the factor, are those of the unit matrix
// with right-hand side zero.
#include "solve/substeps/joint_loops.h"

#include <algorithm>

namespace epode {
namespace {

constexpr int kMaxPartners = 12;  // couplings per joint, on average
constexpr int kMaxBlocks = 24;    // of the factor, per joint

double wide_dot(Vec3 a, Vec3 b)
{
    return double(a.x) * double(b.x) + double(a.y) * double(b.y) + double(a.z) * double(b.z);
}

bool moves(const RowSystem& system, int body)
{
    return body >= 0 && system.bodies[std::size_t(body)].inv_mass > 0;
}

std::span<const NetworkRow> rows_of(const NetworkJoint& joint, std::span<const NetworkRow> rows)
{
    return rows.subspan(std::size_t(joint.first), std::size_t(joint.count));
}

}  // namespace

bool JointLoops::build(const RowSystem& system, std::span<const NetworkJoint> joints,
                       SymbolicCache* symbolic_cache, Arena& arena)
{
    worth_ = false;
    if (!list_couplings(system, joints, arena)) return false;
    if (couplings_.size() > kMaxPartners * joints.size()) return true;
    auto pairs = arena.take<BodyPair>(int(couplings_.size()));
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {couplings_[i].a, couplings_[i].b};
    if (!lease_.take(int(joints.size()), pairs, symbolic_cache, arena)) return false;
    worth_ = std::size_t(lease_.symbolic().blocks) <= kMaxBlocks * joints.size();
    return true;
}

// The joints of each body that moves, side by side, and then every pair of them.
bool JointLoops::list_couplings(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena)
{
    const int bodies = int(system.bodies.size());
    auto first = arena.take_zeroed<int>(bodies + 1);
    auto fill = arena.take<int>(bodies);
    auto ends = arena.take<int>(2 * int(joints.size()));
    if (arena.failed()) return false;
    const auto for_ends = [&](auto&& visit) {
        for (std::size_t j = 0; j < joints.size(); ++j)
            for (int side = 0; side < 2; ++side)
                if (const int b = joints[j].body[side]; b < bodies && moves(system, b))
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
    const std::size_t limit = kMaxPartners * joints.size() + 1;  // so many are too many, whichever they are
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

bool JointLoops::prepare(std::span<const NetworkJoint> joints, Arena& arena)
{
    x_ = arena.take<double>(kMaxRows * int(joints.size()));
    diagonals_ = arena.take<double*>(int(joints.size()));
    if (arena.failed() || !A_.prepare(lease_.symbolic(), Tasks(1), arena)) return false;
    for (std::size_t j = 0; j < joints.size(); ++j) diagonals_[j] = A_.diagonal(int(j));
    for (Coupling& c : couplings_)
        if (c.a != c.b) c.block = A_.between(c.a, c.b, c.transposed);
    return true;
}

void JointLoops::fill_diagonal(const NetworkJoint& joint, std::span<const NetworkRow> all, double* D) const
{
    const auto rows = rows_of(joint, all);
    for (int i = 0; i < 6; ++i) D[7 * i] = 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].place != RowPlace::kFactor) continue;
        for (std::size_t j = 0; j <= i; ++j) {
            if (rows[j].place != RowPlace::kFactor) continue;
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

void JointLoops::fill_coupling(const Coupling& c, std::span<const NetworkJoint> joints,
                               std::span<const NetworkRow> rows) const
{
    // A joint of a body with itself has no effect.
    if (c.a == c.b) return;
    const NetworkJoint &a = joints[std::size_t(c.a)], &b = joints[std::size_t(c.b)];
    const auto rows_a = rows_of(a, rows), rows_b = rows_of(b, rows);
    const auto inv_mass = double(a.inv_mass[c.side_a]);
    for (std::size_t i = 0; i < rows_a.size(); ++i) {
        if (rows_a[i].place != RowPlace::kFactor) continue;
        for (std::size_t j = 0; j < rows_b.size(); ++j) {
            if (rows_b[j].place != RowPlace::kFactor) continue;
            const double sum = inv_mass * wide_dot(rows_a[i].lin[c.side_a], rows_b[j].lin[c.side_b]) +
                               wide_dot(rows_a[i].ang[c.side_a], rows_b[j].turn[c.side_b]);
            c.block[c.transposed ? 6 * i + j : 6 * j + i] += sum;
        }
    }
}

void JointLoops::factor(std::span<const NetworkJoint> joints, std::span<const NetworkRow> rows)
{
    A_.clear();
    for (std::size_t j = 0; j < joints.size(); ++j) fill_diagonal(joints[j], rows, diagonals_[j]);
    for (const Coupling& coupling : couplings_) fill_coupling(coupling, joints, rows);
    (void)A_.factor();
}

void JointLoops::solve(std::span<const NetworkJoint> joints, std::span<const NetworkRow> rows,
                       std::span<double> x)
{
    const auto for_rows = [&](auto&& f) {
        for (std::size_t j = 0; j < joints.size(); ++j)
            for (int i = 0; i < joints[j].count; ++i)
                if (const auto row = std::size_t(joints[j].first + i); rows[row].place == RowPlace::kFactor)
                    f(x[row], x_[kMaxRows * j + std::size_t(i)]);
    };
    std::fill(x_.begin(), x_.end(), 0.0);
    for_rows([](double number, double& padded) { padded = number; });
    A_.solve(x_);
    for_rows([](double& number, double padded) { number = padded; });
}

}  // namespace epode
