// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See compare.h. States are compared as bit patterns, so -0 differs from 0 and a NaN equals itself:
// what counts is whether the two runs did the same.
#include "record/rerun/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace epode::record {

namespace {

template <size_t n>
bool same_bits(const std::array<double, n>& a, const std::array<double, n>& b)
{
    for (size_t i = 0; i < n; ++i) {
        if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
    }
    return true;
}

bool same(const BodyState& a, const BodyState& b)
{
    return same_bits(a.pose.pos, b.pose.pos) && same_bits(a.pose.turn, b.pose.turn) &&
           same_bits(a.linear, b.linear) && same_bits(a.angular, b.angular);
}

double apart(const Vec3& a, const Vec3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

double angle(const Quat& a, const Quat& b)
{
    const double x = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
    const double y = a[0] * b[2] - a[2] * b[0] - a[3] * b[1] + a[1] * b[3];
    const double z = a[0] * b[3] - a[3] * b[0] - a[1] * b[2] + a[2] * b[1];
    const double w = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    return 2 * std::atan2(std::hypot(x, y, z), std::abs(w));
}

}  // namespace

Difference distance(const BodyState& a, const BodyState& b)
{
    return {0,
            0,
            apart(a.pose.pos, b.pose.pos),
            angle(a.pose.turn, b.pose.turn),
            apart(a.linear, b.linear),
            apart(a.angular, b.angular)};
}

std::string incomparable(const Recording& a, const Recording& b)
{
    const size_t steps = std::min(a.steps.size(), b.steps.size());
    if (steps == 0) return "one of them has no state";
    for (size_t step = 0; step < steps; ++step) {
        if (a.steps[step].bodies.size() != b.steps[step].bodies.size()) {
            return "step " + std::to_string(step) + " has " + std::to_string(a.steps[step].bodies.size()) +
                   " bodies in one and " + std::to_string(b.steps[step].bodies.size()) + " in the other";
        }
    }
    return {};
}

std::optional<Difference> first_difference(const Recording& a, const Recording& b)
{
    for (size_t step = 0; step < std::min(a.steps.size(), b.steps.size()); ++step) {
        const auto& first = a.steps[step].bodies;
        const auto& second = b.steps[step].bodies;
        for (size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
            if (same(first[i], second[i])) continue;
            Difference difference = distance(first[i], second[i]);
            difference.step = step;
            difference.body = a.living(step)[i];
            return difference;
        }
    }
    return std::nullopt;
}

StepDistance worst_distance(const Recording& a, const Recording& b, size_t step)
{
    StepDistance worst;
    const auto& first = a.steps[step].bodies;
    const auto& second = b.steps[step].bodies;
    size_t farthest = 0;
    for (size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
        const Difference each = distance(first[i], second[i]);
        if (each.pos > worst.pos) farthest = i;
        worst.pos = std::max(worst.pos, each.pos);
        worst.turn = std::max(worst.turn, each.turn);
    }
    const auto numbers = a.living(step);
    if (farthest < numbers.size()) worst.body = numbers[farthest];
    return worst;
}

}  // namespace epode::record
