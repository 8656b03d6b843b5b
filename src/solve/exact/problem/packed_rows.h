// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The rows of a box problem that are not fixed, four to a pack, as row_kernels.h reads them: rows of the same
// pair of bodies together, one array per number. A place without a row has an empty Jacobian and moves
// nothing. Of fixed rows (friction in the first phase, two of three) only their constant J^T p is stored
// here.
#pragma once

#include "solve/exact/problem/exact_problem.h"
#include "solve/exact/problem/row_kernels.h"

namespace epode {

class PackedRows {
  public:
    explicit PackedRows(const RowKernels& kernels = *row_kernels().back()) : kernels_(&kernels) {}

    bool prepare(const ExactProblem& problem, Arena& arena);  // false: out of memory
    void pack(const ExactProblem& problem, const BoxState& state);
    void unpack(BoxState& state) const;                   // p and tags
    void take_impulses(std::span<const double> of_rows);  // p only

    int max_places() const { return int(places_.size()); }  // for any choice of fixed rows
    int count() const { return int(row_.size()); }          // places, a multiple of four
    int row(int i) const { return row_[std::size_t(i)]; }

    // out = J v
    void products(std::span<const double> v, std::span<double> out) const
    {
        kernels_->products(groups.data(), int(groups.size()), v.data(), out.data());
        for (const WidePlace& wide : wide_) out[wide.place] = wide_product(wide.row->terms(), v.data());
    }
    // x += J^T s
    void add_transposed(std::span<const double> s, std::span<double> x) const
    {
        kernels_->add_transposed(groups.data(), int(groups.size()), s.data(), x.data());
        for (const WidePlace& wide : wide_) add_wide_transposed(wide.row->terms(), s[wide.place], x.data());
    }
    // r = M (v* - v) + J^T p of the fixed rows
    void momentum_change(const ExactProblem& problem, std::span<const double> v, std::span<double> r) const;
    // v = v* + M^-1 J^T p; `momentum` is scratch
    void velocities(const ExactProblem& problem, std::span<double> momentum, std::span<double> v) const;
    // Factors H = M + J^T D J.
    void factor(ExactProblem& problem, std::span<const double> D);

    const RowKernels& kernels() const { return *kernels_; }

    std::span<RowGroup> groups;
    std::span<double> c, C, d, inv_d, weight_min, lo, hi, p;  // one number per place
    std::span<BoxState::Tag> tag;                             // kFixed: no row

  private:
    void begin_group(const ExactRow& row);
    void put(const ExactProblem& problem, const BoxState& state, int row);
    void fill_up();

    // A row of a coupling. Its pack has an empty Jacobian, so kernels pass it by.
    struct WidePlace {
        std::size_t place, order;  // among the problem's wide rows
        const ExactRow* row;
    };

    const RowKernels* kernels_;
    std::span<WidePlace> all_wide_, wide_;
    std::span<double> wide_weights_;
    std::span<RowGroup> all_groups_;
    std::span<double> J_, fixed_;  // of the packs; J^T p of fixed rows
    std::span<double> numbers_;
    std::span<BoxState::Tag> tags_;
    std::span<int> places_, row_;  // row of a place or -1
    std::size_t group_count_ = 0, place_count_ = 0, J_used_ = 0;
};

}  // namespace epode
