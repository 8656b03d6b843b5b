// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Couplings that are no straight lines (MJCF's polycoef): sum f_i q_i - p(x) = offset, where p has the powers from the second on, and x is
// what the second joint, or the second tendon, is off its reference: x = sum g_i (q_i - r_i). At x0 the tangent
//     p(x) = p(x0) + p'(x0) (x - x0)
// makes a line of it: the inner joints count p'(x0) g_i less, and the offset is p(x0) - p'(x0) (x0 + sum g_i r_i) more.
#pragma once

#include "robots/model.h"

namespace epode::robots {

struct Bend {
    std::vector<Coupling::Term> inner;  // g
    std::vector<double> powers;         // of p, from the second on; empty: a straight line
};
Bend bend_of(const RobotModel& model, const Coupling& coupling);

struct BendTangent {
    double x = 0, value = 0, slope = 0;  // x0, p, p'
    double offset = 0;                   // what the coupling's grows by
};
BendTangent tangent_of(const RobotModel& model, const Bend& bend, const std::vector<double>& positions);

}  // namespace epode::robots
