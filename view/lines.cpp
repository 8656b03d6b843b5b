// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See lines.h.
#include "view/lines.h"

#include <algorithm>
#include <cmath>

namespace epode::view {

Vec unit(Vec v)
{
    const double n = scenes::length(v);
    return n > 0 && std::isfinite(n) ? (1 / n) * v : Vec{0, 0, 1};
}

Vec across(Vec v)
{
    const Vec u = unit(v);
    return unit(scenes::cross(u, std::abs(u.z) < 0.9 ? scenes::kZ : scenes::kX));
}

void Lines::line(Vec a, Vec b, viewer::Color color)
{
    viewer::Line line;
    const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
    for (int i = 0; i < 3; ++i) {
        if (!std::isfinite(from[i]) || !std::isfinite(to[i])) return;
        line.a[i] = float(from[i]);
        line.b[i] = float(to[i]);
    }
    line.color = color;
    to_.push_back(line);
}

void Lines::arrow(Vec from, Vec by, viewer::Color color)
{
    const double n = scenes::length(by);
    if (!(n > 0)) return;
    const Vec tip = from + by, back = -0.25 * by, side = across(by);
    const Vec other = unit(scenes::cross(by, side));
    line(from, tip, color);
    for (const Vec& wing : {side, other}) {
        line(tip, tip + back + (0.11 * n) * wing, color);
        line(tip, tip + back - (0.11 * n) * wing, color);
    }
}

void Lines::cross(Vec at, double size, viewer::Color color)
{
    for (const Vec& axis : {scenes::kX, scenes::kY, scenes::kZ})
        line(at - size * axis, at + size * axis, color);
}

void Lines::box(Vec low, Vec high, viewer::Color color)
{
    const auto corner = [&](int i) {
        return Vec{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
    };
    for (int i = 0; i < 8; ++i) {
        for (int bit : {1, 2, 4}) {
            if (!(i & bit)) line(corner(i), corner(i | bit), color);
        }
    }
}

void Lines::arc(Vec center, Vec axis, Vec zero, double radius, double from, double to, viewer::Color color)
{
    const Vec x = unit(zero), y = scenes::cross(unit(axis), x);
    const int pieces = std::max(2, int(std::ceil(std::abs(to - from) / 0.15)));
    const auto at = [&](double angle) {
        return center + (radius * std::cos(angle)) * x + (radius * std::sin(angle)) * y;
    };
    for (int i = 0; i < pieces; ++i) {
        const double step = (to - from) / pieces;
        line(at(from + i * step), at(from + (i + 1) * step), color);
    }
    line(center, at(from), color);
    line(center, at(to), color);
}

}  // namespace epode::view
