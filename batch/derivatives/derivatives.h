// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Derivatives of one copy's step, d(next state)/d(columns), in lanes: a lane is a column, two groups of copies stand on both sides of the
// state along it (lanes/sensitivity.h). First the copy's own step is solved, tightly; its impulses are where both sides begin, or what
// they keep.
//   differences    both sides are stepped
//   exact          both sides keep the impulses, and the rows that act make up for the rest
// A side is cut off where controls and numbers end: the derivative is then one of the inner side, and outside it is 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "batch/derivatives/active_set.h"
#include "batch/derivatives/request.h"
#include "batch/lanes/group.h"
#include "batch/lanes/kernels.h"

namespace epode::batch {

template <typename T>
class Derivatives {
  public:
    Derivatives(const BatchModel& model, const ModelView& view, const Kernels<T>& kernels)
        : model_(model),
          view_(view),
          kernels_(kernels),
          at_(view),
          lanes_(std::size_t(kernels.lanes)),
          tangents_(std::size_t(2 * view.velocities + view.filters)),
          active_(view.velocities, view.impulses(), view.slots)
    {
        const auto group = std::size_t(at_.rows) * lanes_;
        const int rows = view.impulses();
        const auto seed = std::size_t(2 * view.velocities) * lanes_;
        const std::size_t sizes[] = {
            group, group, group, seed, lanes_, 2 * std::size_t(rows) * lanes_, tangents_ * lanes_};
        T** to[] = {&middle_, &plus_, &minus_, &seed_, &rate_, &errors_, &out_};
        std::size_t all = 0;
        for (const std::size_t size : sizes) all += padded(size);
        memory_.reset(static_cast<T*>(::operator new(all * sizeof(T), std::align_val_t(64))));
        T* next = memory_.get();
        for (int i = 0; i < 7; ++i) *to[i] = next, next += padded(sizes[i]);
        found_.resize(std::size_t(rows)), y_.resize(std::size_t(rows * view.velocities)),
            response_.resize(y_.size());
    }

    // Of a copy: its rows of a group, one number each, its numbers of the model, and the model's own.
    void find(const T* rows, const T* numbers, const T* models, const StepOptions& options,
              const DerivativeOptions& how, const std::vector<ColumnBlock>& blocks, void* work)
    {
        options_ = options, numbers_ = numbers, models_ = models, work_ = work;
        options_.tolerance = std::min(options.tolerance, sizeof(T) == 4 ? 1e-6 : 1e-13);
        options_.most_sweeps = std::max(options.most_sweeps, kLeastSweeps);
        distance_ = T(how.distance > 0 ? how.distance : kDistance);
        rows_.assign(rows, rows + at_.rows);
        solve(how.exact);
        columns_.clear();
        for (const ColumnBlock& block : blocks)
            for (int i = 0; i < block.columns; ++i) columns_.push_back({&block, i});
        for (std::size_t first = 0; first < columns_.size(); first += lanes_)
            find(columns_.data() + first, std::min(columns_.size() - first, lanes_), how.exact);
    }

  private:
    static constexpr int kLeastSweeps = 2000;
    static constexpr double kDistance = sizeof(T) == 4 ? 1.0 / 256 : 1.0 / 131072;

    static std::size_t padded(std::size_t numbers)
    {
        return (numbers * sizeof(T) + 63) / 64 * 64 / sizeof(T);
    }
    struct Free {
        void operator()(T* memory) const { ::operator delete(memory, std::align_val_t(64)); }
    };
    T& number(T* group, int row, std::size_t lane) const { return group[std::size_t(row) * lanes_ + lane]; }
    std::size_t group_bytes() const { return std::size_t(at_.rows) * lanes_ * sizeof(T); }

    void spread()
    {
        for (int row = 0; row < at_.rows; ++row)
            std::fill_n(middle_ + std::size_t(row) * lanes_, lanes_, rows_[std::size_t(row)]);
    }

    // The copy's impulses become those that solve its step, in all lanes.
    void solve(bool exact)
    {
        spread();
        if (view_.impulses() > 0) {
            std::memcpy(plus_, middle_, group_bytes());
            kernels_.step(view_, options_, numbers_, false, plus_, work_);
            for (int i = 0; i < view_.impulses(); ++i)
                rows_[std::size_t(at_.forces + i)] = number(plus_, at_.forces + i, 0);
            spread();
        }
        options_.evening = 0;
        if (!exact) return;
        int count = 0;
        if (view_.impulses() > 0) {
            std::memcpy(plus_, middle_, group_bytes());
            count = kernels_.respond(view_, options_, numbers_, plus_, work_, found_.data(), y_.data(),
                                     response_.data());
        }
        active_.find(count, found_.data(), y_.data(), response_.data());
    }

    struct Column {
        const ColumnBlock* block;
        int number;
    };

    void find(const Column* columns, std::size_t count, bool exact)
    {
        std::memcpy(plus_, middle_, group_bytes()), std::memcpy(minus_, middle_, group_bytes());
        std::fill_n(seed_, std::size_t(2 * view_.velocities) * lanes_, T(0)),
            std::fill_n(rate_, lanes_, T(0));
        const bool own = std::any_of(columns, columns + count, [](const Column& column) {
            return column.block->kind == ColumnBlock::kParameter;
        });
        if (own) spread_numbers();
        for (std::size_t i = 0; i < count; ++i) set_apart(*columns[i].block, columns[i].number, i);
        const Apart<T> pair{plus_,
                            minus_,
                            own ? own_plus_.data() : numbers_,
                            own ? own_minus_.data() : numbers_,
                            own,
                            seed_,
                            rate_,
                            errors_,
                            out_};
        kernels_.differentiate(view_, options_, pair, exact ? &active_.set() : nullptr, work_);
        for (std::size_t i = 0; i < count; ++i) put_column(columns[i], i);
    }

    void put_column(const Column& column, std::size_t lane) const
    {
        T* to = static_cast<T*>(column.block->to) + column.number;
        for (std::size_t k = 0; k < tangents_; ++k, to += column.block->columns)
            *to = out_[k * lanes_ + lane];
    }

    void set_apart(const ColumnBlock& block, int column, std::size_t lane)
    {
        const int state = 2 * view_.velocities;
        if (block.kind == ColumnBlock::kParameter) return set_number_apart(block.parameter, column, lane);
        if (block.kind == ColumnBlock::kControls) return set_control_apart(column, lane);
        if (column < state) {
            number(seed_, column, lane) = distance_;
            rate_[lane] = 1 / (2 * distance_);
        } else {
            set_row_apart(at_.activations + column - state, -kAny, kAny, lane);
        }
    }

    // A side beyond an end stays at the end; if both do, nothing moves.
    void set_row_apart(int row, T low, T high, std::size_t lane)
    {
        const T middle = number(middle_, row, lane), plus = std::clamp(middle + distance_, low, high),
                minus = std::clamp(middle - distance_, low, high);
        if (plus == minus) return;
        number(plus_, row, lane) = plus, number(minus_, row, lane) = minus, rate_[lane] = 1 / (plus - minus);
    }

    void set_control_apart(int control, std::size_t lane)
    {
        const T* its = numbers_ + model_.actuators[std::size_t(control)].first;
        set_row_apart(at_.control + control, its[actuator_number::kLow], its[actuator_number::kHigh], lane);
    }

    void spread_numbers()
    {
        const std::size_t count = model_.numbers.size();
        own_plus_.resize(count * lanes_);
        for (std::size_t i = 0; i < count; ++i)
            std::fill_n(own_plus_.data() + i * lanes_, lanes_, numbers_[i]);
        own_minus_ = own_plus_;
    }

    void set_number_apart(Parameter parameter, int which, std::size_t lane)
    {
        const T middle = numbers_[place_of(model_, parameter, which)];
        const T distance = middle != 0 ? distance_ * std::fabs(middle) : T(kDistance / 16),
                plus = middle + distance;
        const bool ends = parameter == Parameter::kFrictions || parameter == Parameter::kTorsions ||
                          parameter == Parameter::kRollings;  // at 0; elsewhere both sides of 0 make sense
        const T minus = ends ? std::max(middle - distance, T(0)) : middle - distance;
        set_number(own_plus_, parameter, which, plus, lane),
            set_number(own_minus_, parameter, which, minus, lane);
        rate_[lane] = 1 / (plus - minus);
    }

    void set_number(std::vector<T>& own, Parameter parameter, int which, T value, std::size_t lane)
    {
        each_number(model_, models_, parameter, which, value,
                    [&](int place, T its) { own[std::size_t(place) * lanes_ + lane] = its; });
    }

    static constexpr T kAny = T(1e30);

    const BatchModel& model_;
    const ModelView& view_;
    const Kernels<T>& kernels_;
    GroupLayout at_;
    std::size_t lanes_, tangents_;
    ActiveRows<T> active_;
    std::unique_ptr<T, Free> memory_;
    T *middle_, *plus_, *minus_, *seed_, *rate_, *errors_, *out_;
    std::vector<T> rows_, own_plus_, own_minus_, y_, response_;
    std::vector<FoundRow<T>> found_;
    std::vector<Column> columns_;
    StepOptions options_;
    const T *numbers_ = nullptr, *models_ = nullptr;
    T distance_ = 0;
    void* work_ = nullptr;
};

}  // namespace epode::batch
