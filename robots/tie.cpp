// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See tie.h.
#include "robots/tie.h"

#include "robots/tendon.h"

namespace epode::robots {

TieCurve curve_of(const Tie& tie, double second_length)
{
    if (tie.tendon2 < 0) return {tie.curve[0], 0};
    const double x = second_length - tie.rest2;
    TieCurve out;
    for (size_t i = tie.curve.size(); i-- > 0;)
        out.slope = out.slope * x + out.value, out.value = out.value * x + tie.curve[i];
    return out;
}

std::vector<double> tie_errors(const RobotModel& model, const std::vector<double>& positions)
{
    std::vector<double> out;
    if (model.ties.empty()) return out;
    const std::vector<double> lengths = tendon_lengths(model, positions);
    for (const Tie& tie : model.ties) {
        const double second = tie.tendon2 < 0 ? 0 : lengths[size_t(tie.tendon2)];
        out.push_back(lengths[size_t(tie.tendon1)] - tie.rest1 - curve_of(tie, second).value);
    }
    return out;
}

std::vector<double> tie_jacobian(const RobotModel& model, const std::vector<double>& positions)
{
    std::vector<double> out;
    if (model.ties.empty()) return out;
    const std::vector<double> lengths = tendon_lengths(model, positions);
    for (const Tie& tie : model.ties) {
        std::vector<double> row = tendon_moments(model, positions, std::array{tie.tendon1});
        if (tie.tendon2 >= 0) {
            const double slope = curve_of(tie, lengths[size_t(tie.tendon2)]).slope;
            const std::vector<double> other = tendon_moments(model, positions, std::array{tie.tendon2});
            for (size_t i = 0; i < row.size(); ++i) row[i] -= slope * other[i];
        }
        out.insert(out.end(), row.begin(), row.end());
    }
    return out;
}

}  // namespace epode::robots
