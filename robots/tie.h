// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Equalities of tendons with a path (Tie, model.h): how far one is from what it asks, e = L - r - c(K - s), and that by the velocities,
// the row of L less c' times that of K.
#pragma once

#include "robots/model.h"

namespace epode::robots {

// What the curve gives for the second tendon's length, beyond the first's r, and its slope c' there.
struct TieCurve {
    double value = 0, slope = 0;
};
TieCurve curve_of(const Tie& tie, double second_length);

// Of all ties: e, and the rows of its derivatives.
std::vector<double> tie_errors(const RobotModel& model, const std::vector<double>& positions);
std::vector<double> tie_jacobian(const RobotModel& model, const std::vector<double>& positions);

}  // namespace epode::robots
