// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What an episode draws (task.h): where a copy starts, and parameters of its model. By the thread that has stepped the copy, so in
// memory that is there before (Scratch): nothing is allocated.
#pragma once

#include "batch/tasks/random.h"
#include "batch/tasks/task.h"

namespace epode::batch {

constexpr int kDraws = 1000;  // tries, before what cannot be is let alone

// Of one thread, as large as the largest draw.
template <typename T>
struct Scratch {
    std::vector<T> positions, velocities, values;
    std::vector<double> drawn;

    Scratch(const BatchModel& model, const Task& task)
        : positions(std::size_t(model.positions)), velocities(std::size_t(model.velocities))
    {
        std::size_t most = 0;
        for (const Start& start : task.starts) most = std::max(most, start.low.size());
        drawn.reserve(most), most = 3;  // where a field is
        for (const Draw& draw : task.draws)
            most = std::max(most, std::size_t(size_of(model, draw.parameter)));
        values.reserve(most);
    }
};

inline double drawn(Random& random, bool is_normal, double low, double high)
{
    return is_normal ? low + high * random.normal() : random.uniform(low, high);
}

template <typename T>
void draw_start(const Start& start, Random& random, Scratch<T>& scratch)
{
    std::vector<double>& x = scratch.drawn;
    x.resize(start.low.size());
    for (int tries = 0; tries < kDraws; ++tries) {
        double square = 0;
        for (std::size_t k = 0; k < x.size(); ++k)
            x[k] = drawn(random, start.is_normal, start.low[k], start.high[k]), square += x[k] * x[k];
        const double length = std::sqrt(square);
        if (length > start.min_length && length < start.max_length) break;
    }
    for (std::size_t k = 0; k < x.size(); ++k) {
        T& value = (start.is_velocity ? scratch.velocities : scratch.positions)[std::size_t(start.first) + k];
        value = T(start.is_relative ? double(value) + x[k] : x[k]);
    }
}

inline void draw_commands(const Commands& commands, Random& random, double* to)
{
    const bool none = random.uniform() < commands.none;
    for (std::size_t k = 0; k < commands.low.size(); ++k) {
        const double x = random.uniform(commands.low[k], commands.high[k]);
        to[k] = none ? 0 : x;
    }
}

// The row that follows, of the curriculum; `moved`: how far the last episode led, below 0: there was none.
inline int next_row(const Curriculum& its, int row, double moved, Random& random)
{
    const auto any_of = [&](int rows) { return std::min(rows - 1, int(random.uniform() * rows)); };
    if (moved < 0) return any_of(std::min(its.first_rows, its.rows));
    if (moved > its.up) return row + 1 < its.rows ? row + 1 : any_of(its.rows);
    return moved < its.down ? std::max(0, row - 1) : row;
}

// What the parameter cannot be is drawn again; `models` are the numbers of the model.
template <typename T>
void draw_parameter(AnyBatch& batch, const Draw& draw, const std::vector<T>& models, Random& random, int copy,
                    Scratch<T>& scratch)
{
    std::vector<T>& values = scratch.values;
    values.assign(models.begin(), models.end());
    double x = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
        for (int tries = 0; tries < kDraws; ++tries) {
            if (k == 0 || draw.is_each || tries > 0) x = drawn(random, draw.is_normal, draw.low, draw.high);
            values[k] = T(draw.scales ? x * double(models[k]) : x);
            if (can_be(batch.model(), draw.parameter, int(k), double(values[k]))) break;
            values[k] = models[k];
        }
    batch.write(draw.parameter, copy, 1, values.data());
}

}  // namespace epode::batch
