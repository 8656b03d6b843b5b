// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The first place at which two recordings differ, bit by bit, and how far apart they are at every step.
#pragma once

#include <optional>

#include "record/file/recording.h"

namespace epode::record {

struct Difference {
    size_t step;  // 0: the initial state
    std::uint32_t body;
    double pos, turn, linear, angular;  // distances: m, rad, m/s, rad/s
};

// How far two states are apart. The angle is that of the turn between the two: 2 asin |vector part of
// conj(q1) q2|.
Difference distance(const BodyState& a, const BodyState& b);

struct StepDistance {
    double pos = 0, turn = 0;  // the worst body's
    std::uint32_t body = 0;    // the one that is farthest
};

// "" where both have the same bodies in every step that both have; otherwise what is different about them.
std::string incomparable(const Recording& a, const Recording& b);
// Only of recordings that can be compared.
std::optional<Difference> first_difference(const Recording& a, const Recording& b);
StepDistance worst_distance(const Recording& a, const Recording& b, size_t step);

}  // namespace epode::record
