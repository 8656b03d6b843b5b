// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows keep their order; a group ends where the pair of bodies changes. The contacts of two touching bodies
// are neighbours in an island, so nothing is sorted.
#include "solve/exact/problem/packed_rows.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr int kPack = 4;  // rows of a pack, as in row_kernels.inc

int columns(const RowGroup& group) { return group.b < 0 ? 6 : 12; }

bool same_bodies(const ExactRow& x, const ExactRow& y) { return x.a == y.a && x.b == y.b; }

}  // namespace

bool PackedRows::prepare(const ExactProblem& problem, Arena& arena)
{
    int groups_needed = 0, packs = 0;
    std::size_t J_needed = 0;
    for (int i = 0; i < problem.row_count();) {
        const int first = i;
        while (i < problem.row_count() && same_bodies(problem.row(i), problem.row(first))) ++i;
        const int more = (i - first + kPack - 1) / kPack;
        ++groups_needed;
        packs += more;
        J_needed += std::size_t(more) * kPack * (problem.row(first).b < 0 ? 6 : 12);
    }
    all_groups_ = arena.take<RowGroup>(groups_needed);
    J_ = arena.take<double>(int(J_needed));
    fixed_ = arena.take<double>(problem.unknowns());
    numbers_ = arena.take<double>(8 * kPack * packs);
    tags_ = arena.take<BoxState::Tag>(kPack * packs);
    places_ = arena.take<int>(kPack * packs);
    const int wide = int(problem.wide_rows().size());
    all_wide_ = arena.take<WidePlace>(wide);
    wide_weights_ = arena.take<double>(wide);
    return !arena.failed();
}

void PackedRows::pack(const ExactProblem& problem, const BoxState& state)
{
    std::fill(fixed_.begin(), fixed_.end(), 0.0);
    const std::size_t capacity = places_.size();
    std::span<double>* const columns_of[] = {&c, &C, &d, &inv_d, &weight_min, &lo, &hi, &p};
    for (std::size_t k = 0; k < 8; ++k) *columns_of[k] = numbers_.subspan(k * capacity, capacity);
    tag = tags_, row_ = places_, groups = all_groups_;
    group_count_ = place_count_ = J_used_ = 0;
    wide_ = all_wide_.first(0);
    for (int i = 0; i < problem.row_count(); ++i) {
        const ExactRow& row = problem.row(i);
        if (state.tag[std::size_t(i)] != BoxState::kFixed)
            put(problem, state, i);
        else if (state.p[std::size_t(i)] != 0)
            ExactProblem::add_jt(row, state.p[std::size_t(i)], fixed_.data());
    }
    fill_up();
    for (std::span<double>* column : columns_of) *column = column->first(place_count_);
    tag = tag.first(place_count_), row_ = row_.first(place_count_), groups = groups.first(group_count_);
}

void PackedRows::put(const ExactProblem& problem, const BoxState& state, int i)
{
    const ExactRow& row = problem.row(i);
    if (group_count_ == 0 || groups[group_count_ - 1].a != row.a || groups[group_count_ - 1].b != row.b)
        begin_group(row);
    RowGroup& group = groups[group_count_ - 1];
    const std::size_t at = place_count_++;
    if (at % kPack == 0) {
        ++group.count;
        J_used_ += std::size_t(kPack * columns(group));
    }
    double* J = J_.data() + J_used_ - kPack * columns(group) + at % kPack;
    for (int k = 0; k < columns(group); ++k) J[kPack * k] = row.J[k];
    c[at] = row.c, C[at] = row.C, d[at] = row.d, inv_d[at] = 1 / row.d, weight_min[at] = row.weight_min;
    const auto from = std::size_t(i);
    lo[at] = state.lo[from], hi[at] = state.hi[from], p[at] = state.p[from];
    tag[at] = state.tag[from];
    row_[at] = i;
    if (row.wide_count == 0) return;
    const std::span<const int> order = problem.wide_rows();
    wide_ = all_wide_.first(wide_.size() + 1);
    wide_.back() = {at, std::size_t(std::find(order.begin(), order.end(), i) - order.begin()), &row};
}

void PackedRows::factor(ExactProblem& problem, std::span<const double> D)
{
    std::fill(wide_weights_.begin(), wide_weights_.end(), 0.0);
    for (const WidePlace& wide : wide_) wide_weights_[wide.order] = D[wide.place];
    problem.factor(groups, D, *kernels_, wide_weights_);
}

void PackedRows::begin_group(const ExactRow& row)
{
    fill_up();
    groups[group_count_++] = {J_.data() + J_used_, row.a, row.b, int(place_count_) / kPack, 0, row.pair};
}

// Fills the pack with empty places.
void PackedRows::fill_up()
{
    for (; place_count_ % kPack != 0; ++place_count_) {
        const std::size_t at = place_count_;
        const RowGroup& group = groups[group_count_ - 1];
        double* J = J_.data() + J_used_ - kPack * columns(group) + at % kPack;
        for (int k = 0; k < columns(group); ++k) J[kPack * k] = 0;
        c[at] = C[at] = lo[at] = hi[at] = p[at] = 0;
        d[at] = inv_d[at] = weight_min[at] = 1;
        tag[at] = BoxState::kFixed;
        row_[at] = -1;
    }
}

void PackedRows::unpack(BoxState& state) const
{
    for (std::size_t at = 0; at < row_.size(); ++at) {
        if (row_[at] < 0) continue;
        state.p[std::size_t(row_[at])] = p[at];
        state.tag[std::size_t(row_[at])] = tag[at];
    }
}

void PackedRows::take_impulses(std::span<const double> of_rows)
{
    for (std::size_t at = 0; at < row_.size(); ++at)
        if (row_[at] >= 0) p[at] = of_rows[std::size_t(row_[at])];
}

void PackedRows::momentum_change(const ExactProblem& problem, std::span<const double> v,
                                 std::span<double> r) const
{
    problem.momentum_change(v, r);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] += fixed_[i];
}

void PackedRows::velocities(const ExactProblem& problem, std::span<double> momentum,
                            std::span<double> v) const
{
    std::copy(fixed_.begin(), fixed_.end(), momentum.begin());
    add_transposed(p, momentum);
    problem.velocities_after(momentum, v);
}

}  // namespace epode
