// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows as vectors of twelve numbers, random poses, and what must hold for every joint at any pose:
// its rows make no momentum, and J is the derivative of the error.
//   d(error)/dt = -S J v with ones on the diagonal of S: each row's error falls at the rate its own J
//   measures, up to motions that other rows of the joint forbid.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "rig.h"

namespace epode::test {

inline constexpr Real kTight = kSingle ? Real(2e-4) : Real(1e-9);
inline constexpr Real kDifference = kSingle ? Real(3e-2) : Real(1e-5);

// Uniform numbers from a linear congruence: the contract needs variety, not quality.
struct Dice {
    std::uint32_t state = 12345;
    Real next()
    {
        state = state * 1664525u + 1013904223u;
        return Real(state >> 8) / Real(1 << 23) - 1;
    }
    Vec3 vector()
    {
        const Real x = next(), y = next(), z = next();
        return {x, y, z};
    }
    Vec3 unit() { return normalized_or(vector(), {1, 0, 0}); }
    Quat rotation()
    {
        const Vec3 axis = unit();
        return turn(axis, 3 * next());
    }
};

using Line = std::array<Real, 12>;

inline Line line(const Row& r)
{
    Line out{};
    store(&out[0], r.lin1), store(&out[3], r.ang1), store(&out[6], r.lin2), store(&out[9], r.ang2);
    return out;
}

inline Real product(const Line& a, const Line& b)
{
    Real s = 0;
    for (int i = 0; i < 12; ++i) s += a[i] * b[i];
    return s;
}

inline std::vector<Line> equality_lines(const std::vector<Row>& rows)
{
    std::vector<Line> out;
    for (const Row& r : rows)
        if (r.kind == RowKind::kLock) out.push_back(line(r));
    return out;
}

// What is left of x after taking out its part in the span of `lines` (orthonormalised on the way).
inline Line outside_span(std::vector<Line> lines, Line x)
{
    std::vector<Line> basis;
    for (Line l : lines) {
        for (int pass = 0; pass < 2; ++pass)
            for (const Line& b : basis) {
                const Real k = product(l, b);
                for (int i = 0; i < 12; ++i) l[i] -= k * b[i];
            }
        const Real size = std::sqrt(product(l, l));
        if (size < 1e-6) continue;
        for (Real& v : l) v /= size;
        basis.push_back(l);
    }
    for (int pass = 0; pass < 2; ++pass)
        for (const Line& b : basis) {
            const Real k = product(x, b);
            for (int i = 0; i < 12; ++i) x[i] -= k * b[i];
        }
    return x;
}

inline Real size(const Line& x) { return std::sqrt(product(x, x)); }

// About every body a step to both sides: the slope of each error, against its own row.
inline void expect_exact_derivative(const Rig& rig, dJointID joint, Body* a, Body* b)
{
    const Real t = kSingle ? Real(1e-3) : Real(1e-6);
    const std::vector<Row> rows = rig.emit(joint).rows;
    const std::vector<Line> lines = equality_lines(rows);
    std::vector<Line> slope(lines.size());
    for (int k = 0; k < (b ? 12 : 6); ++k) {
        Body* moved = k < 6 ? a : b;
        const Vec3 x = moved->position();
        const Quat q = moved->orientation();
        Vec3 d;
        d.set(k % 3, 1);
        std::vector<Row> at[2];
        for (int side = 0; side < 2; ++side) {
            const Real step = side ? t : -t;
            if (k % 6 < 3)
                Rig::place(moved, x + step * d, q);
            else
                Rig::place(moved, x, turn(d, step) * q);
            at[side] = rig.emit(joint).rows;
        }
        Rig::place(moved, x, q);
        for (std::size_t i = 0, r = 0; i < rows.size(); ++i)
            if (rows[i].kind == RowKind::kLock)
                slope[r++][std::size_t(k)] = (at[1][i].error - at[0][i].error) / (2 * t);
    }
    for (std::size_t r = 0; r < lines.size(); ++r) {
        Line sum{};
        for (std::size_t k = 0; k < 12; ++k) sum[k] = slope[r][k] + lines[r][k];
        std::vector<Line> others = lines;
        others.erase(others.begin() + std::ptrdiff_t(r));
        EXPECT_LT(size(outside_span(others, sum)), kDifference) << "row " << r;
    }
}

inline void expect_momentum(const Rig& rig, dJointID joint, const Body* a, const Body* b)
{
    for (const Row& r : rig.emit(joint).rows) {
        const Vec3 moment = cross(a->position(), r.lin1) + r.ang1 + cross(b->position(), r.lin2) + r.ang2;
        EXPECT_LT(length(r.lin1 + r.lin2), kTight);
        EXPECT_LT(length(moment), kTight);
    }
}

}  // namespace epode::test
