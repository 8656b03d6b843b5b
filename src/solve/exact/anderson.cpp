// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/exact/anderson.h"

#include <algorithm>

namespace epode {
namespace {

constexpr double kRegular = 1e-10;  // share by which the diagonal of the normal equations is raised

double weighted_dot(std::span<const double> a, std::span<const double> b, std::span<const double> weights)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += weights[i] * weights[i] * a[i] * b[i];
    return sum;
}

}  // namespace

bool Anderson::prepare(int unknowns, Arena& arena)
{
    for (std::span<double>* all : {&x_, &g_, &f_}) *all = arena.take<double>(unknowns);
    for (std::span<double>& column : dg_) column = arena.take<double>(unknowns);
    for (std::span<double>& column : df_) column = arena.take<double>(unknowns);
    return !arena.failed();
}

void Anderson::advance(std::span<const double> g, std::span<const double> weights)
{
    remember(g);
    double gamma[kDepth] = {};
    combine(weights, gamma);
    for (std::size_t i = 0; i < x_.size(); ++i) {
        double next = g[i];
        for (int k = 0; k < depth_; ++k) next -= gamma[k] * dg_[k][i];
        x_[i] = std::max(next, 0.0);
    }
}

// The first g belongs to no x.
void Anderson::remember(std::span<const double> g)
{
    const bool has_before = points_ > 1;
    if (has_before) {
        std::rotate(dg_, dg_ + kDepth - 1, dg_ + kDepth);
        std::rotate(df_, df_ + kDepth - 1, df_ + kDepth);
        depth_ = std::min(depth_ + 1, kDepth);
    }
    for (std::size_t i = 0; i < g.size(); ++i) {
        const double f = points_ > 0 ? g[i] - x_[i] : 0;
        if (has_before) dg_[0][i] = g[i] - g_[i], df_[0][i] = f - f_[i];
        g_[i] = g[i], f_[i] = f;
    }
    ++points_;
}

void Anderson::combine(std::span<const double> weights, double (&gamma)[kDepth]) const
{
    double A[kDepth][kDepth];
    for (int i = 0; i < depth_; ++i) {
        gamma[i] = weighted_dot(df_[i], f_, weights);
        for (int j = 0; j <= i; ++j) A[i][j] = A[j][i] = weighted_dot(df_[i], df_[j], weights);
    }
    for (int i = 0; i < depth_; ++i) A[i][i] += kRegular * A[i][i];
    for (int i = 0; i < depth_; ++i) {
        if (!(A[i][i] > 0)) continue;
        for (int j = i + 1; j < depth_; ++j) {
            const double factor = A[j][i] / A[i][i];
            for (int k = i; k < depth_; ++k) A[j][k] -= factor * A[i][k];
            gamma[j] -= factor * gamma[i];
        }
    }
    for (int i = depth_ - 1; i >= 0; --i) {
        for (int k = i + 1; k < depth_; ++k) gamma[i] -= A[i][k] * gamma[k];
        gamma[i] = A[i][i] > 0 ? gamma[i] / A[i][i] : 0;
    }
}

}  // namespace epode
