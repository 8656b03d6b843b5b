// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Evaluates pieces and terms of a task (task.h) from arrays of copies, in doubles. T: the batch's numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "batch/lanes/angles.h"
#include "batch/tasks/ground.h"
#include "batch/tasks/random.h"
#include "batch/tasks/task.h"

namespace epode::batch {

// Arrays (n, size) of the quantities that a task needs, actions among them.
template <typename T>
struct Arrays {
    std::array<std::vector<T>, std::size_t(Quantity::kCount)> of;
    std::array<std::size_t, std::size_t(Quantity::kCount)> sizes{};
    std::vector<double> actions, last_actions, commands, rows;
    std::size_t action_size = 0, command_size = 0;
    const AnyBatch* batch = nullptr;
    std::unique_ptr<Ground> ground;  // if heights are wanted

    const T* row(Quantity quantity, int copy) const
    {
        return of[std::size_t(quantity)].data() + std::size_t(copy) * sizes[std::size_t(quantity)];
    }
};

template <typename T>
class Terms {
  public:
    explicit Terms(const Arrays<T>& arrays) : arrays_(arrays) {}

    // take(k, number) of all numbers of the piece.
    template <typename Take>
    void each(const Piece& piece, int copy, const Take& take) const
    {
        const auto finished = [&](double x) {
            return std::min(std::max(piece.scale * (x - piece.offset), piece.low), piece.high);
        };
        if (piece.source == Piece::Source::kHeight)
            return each_height(piece, copy, [&](int k, double x) { take(k, finished(x)); });
        if (piece.source == Piece::Source::kQuantity && piece.function == Piece::Function::kNone &&
            piece.minus < 0 && piece.command < 0 && piece.axes_of < 0) {
            const T* row = arrays_.row(piece.quantity, copy) + piece.first;  // nearly all of most tasks
            for (int k = 0; k < piece.count; ++k) take(k, finished(double(row[k])));
            return;
        }
        for (int k = 0; k < piece.count; ++k) {
            const double other = piece.minus < 0 ? 0 : raw(piece, copy, piece.minus + k),
                         wanted = piece.command < 0 ? 0 : command(copy, piece.command + k);
            take(k, finished(applied(piece.function, raw(piece, copy, piece.first + k) - other - wanted)));
        }
    }

    double sum(const Piece& piece, int copy) const
    {
        double out = 0;
        each(piece, copy, [&](int, double x) { out += x; });
        return out;
    }

    bool is_within(const Range& range, int copy) const
    {
        bool good = true;
        each(range.piece, copy, [&](int, double x) {
            good &= range.is_open ? x > range.low && x < range.high : x >= range.low && x <= range.high;
        });
        return good;
    }

    // Rates are told apart: what they are of, now and at the step's begin, and the time between.
    double value(const Term& term, int copy, bool is_healthy, double before, double time) const
    {
        return std::min(std::max(term.weight * plain(term, copy, is_healthy, before, time), term.low),
                        term.high);
    }

  private:
    double plain(const Term& term, int copy, bool is_healthy, double before, double time) const
    {
        if (term.kind == Term::Kind::kConstant) return 1;
        if (term.kind == Term::Kind::kHealthy) return is_healthy ? 1 : 0;
        if (term.kind == Term::Kind::kSum) return sum(term.piece, copy);
        if (term.kind == Term::Kind::kRate) return time > 0 ? (sum(term.piece, copy) - before) / time : 0;
        double squares = 0;
        each(term.piece, copy, [&](int, double x) { squares += x * x; });
        if (term.kind == Term::Kind::kGaussian) return exponential(-squares / term.width);
        return term.kind == Term::Kind::kLength ? std::sqrt(squares) : squares;
    }

    // Infinite where there is no ground.
    template <typename Take>
    void each_height(const Piece& piece, int copy, const Take& take) const
    {
        const T* p = arrays_.row(Quantity::kLinkPositions, copy) + 3 * piece.link;
        T terrain[3];
        arrays_.batch->read(Parameter::kTerrain, copy, 1, terrain);
        const double x = double(p[0]) - double(terrain[0]), y = double(p[1]) - double(terrain[1]),
                     z = double(p[2]) - double(terrain[2]);
        const auto [cosine, sine] = heading(copy, piece.link);
        for (int k = 0; k < piece.count; ++k) {
            const auto& [ahead, left] = piece.places[std::size_t(piece.first + k)];
            take(k, z - arrays_.ground->height(x + cosine * ahead - sine * left,
                                               y + sine * ahead + cosine * left));
        }
    }

    // Cosine and sine of where a link's x heads, seen from above; x of the world where that is straight up or down.
    std::array<double, 2> heading(int copy, int link) const
    {
        const T* q = arrays_.row(Quantity::kLinkTurns, copy) + 4 * link;
        const double w = double(q[0]), x = double(q[1]), y = double(q[2]), z = double(q[3]);
        const double ahead = 1 - 2 * (y * y + z * z), left = 2 * (x * y + w * z);
        const double length = std::sqrt(ahead * ahead + left * left);
        if (!(length > 1e-6)) return {1, 0};
        return {ahead / length, left / length};
    }

    double command(int copy, int number) const
    {
        return arrays_.commands[std::size_t(copy) * arrays_.command_size + std::size_t(number)];
    }

    double raw(const Piece& piece, int copy, int number) const
    {
        const auto i = std::size_t(number), action = std::size_t(copy) * arrays_.action_size + i;
        switch (piece.source) {
            case Piece::Source::kQuantity:
                return piece.axes_of < 0 ? double(arrays_.row(piece.quantity, copy)[i])
                                         : turned(piece, copy, number);
            case Piece::Source::kAction:
                return arrays_.actions[action];
            case Piece::Source::kActionChange:
                return arrays_.actions[action] - arrays_.last_actions[action];
            case Piece::Source::kCommand:
                return command(copy, number);
            case Piece::Source::kRow:
                return arrays_.rows[std::size_t(copy)];
            case Piece::Source::kDirection:
                return in_axes(copy, piece.link, piece.point, number);
            case Piece::Source::kPoint:
            case Piece::Source::kHeight:
                break;
        }
        return of_point(piece, copy, number);
    }

    // One of a quantity's three numbers from `first` on, in the axes of a link.
    double turned(const Piece& piece, int copy, int number) const
    {
        const T* row = arrays_.row(piece.quantity, copy) + piece.first;
        const double v[3] = {double(row[0]), double(row[1]), double(row[2])};
        return in_axes(copy, piece.axes_of, v, number - piece.first);
    }

    // R' v: v - 2 w (u x v) + 2 u x (u x v), of a quaternion (w, u).
    double in_axes(int copy, int link, const double* v, int axis) const
    {
        const T* q = arrays_.row(Quantity::kLinkTurns, copy) + 4 * link;
        const double w = double(q[0]), u[3] = {double(q[1]), double(q[2]), double(q[3])};
        double t[3];
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            t[i] = 2 * (u[j] * v[k] - u[k] * v[j]);
        }
        const int j = (axis + 1) % 3, k = (axis + 2) % 3;
        return v[axis] - w * t[axis] + (u[j] * t[k] - u[k] * t[j]);
    }

    // p + R r: r + 2 w (u x r) + 2 u x (u x r), of a quaternion (w, u).
    double of_point(const Piece& piece, int copy, int axis) const
    {
        const T *p = arrays_.row(Quantity::kLinkPositions, copy) + 3 * piece.link,
                *q = arrays_.row(Quantity::kLinkTurns, copy) + 4 * piece.link;
        const double w = double(q[0]), u[3] = {double(q[1]), double(q[2]), double(q[3])};
        const double* r = piece.point;
        double t[3];
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            t[i] = 2 * (u[j] * r[k] - u[k] * r[j]);
        }
        const int j = (axis + 1) % 3, k = (axis + 2) % 3;
        return double(p[axis]) + r[axis] + w * t[axis] + (u[j] * t[k] - u[k] * t[j]);
    }

    // By half the angle, whose sign does not matter here.
    static double applied(Piece::Function function, double x)
    {
        if (function == Piece::Function::kNone) return x;
        const auto half = half_turn(Pack<double, 2>(x));
        double s[2], c[2];
        __builtin_memcpy(s, &half.sine, sizeof s), __builtin_memcpy(c, &half.cosine, sizeof c);
        return function == Piece::Function::kSine ? 2 * s[0] * c[0] : (c[0] - s[0]) * (c[0] + s[0]);
    }

    const Arrays<T>& arrays_;
};

}  // namespace epode::batch
