// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See tendon_armature.h.
#include "robots/tendon_armature.h"

#include "robots/kinematics.h"
#include "robots/tendon.h"

namespace epode::robots {

namespace {

std::vector<int> tendons_with_armature(const RobotModel& model)
{
    std::vector<int> out;
    for (size_t i = 0; i < model.tendons.size(); ++i)
        if (model.tendons[i].armature > 0) out.push_back(int(i));
    return out;
}

}  // namespace

// b J' J, of each tendon with the armature b.
void add_armatures(const RobotModel& model, const std::vector<double>& positions, std::vector<double>& matrix)
{
    const std::vector<int> tendons = tendons_with_armature(model);
    if (tendons.empty()) return;
    const size_t n = size_t(number_of_velocities(model));
    const std::vector<double> rows = tendon_moments(model, positions, tendons);
    for (size_t k = 0; k < tendons.size(); ++k)
        for (size_t i = 0; i < n; ++i)
            for (size_t j = 0; j < n; ++j)
                matrix[i * n + j] +=
                    model.tendons[size_t(tendons[k])].armature * rows[k * n + i] * rows[k * n + j];
}

// b J' (J a + dJ/dt s), the latter as the difference over a short way along the velocities s.
void add_armature_forces(const RobotModel& model, const std::vector<double>& positions,
                         const std::vector<double>& velocities, const std::vector<double>& accelerations,
                         std::vector<double>& forces)
{
    const std::vector<int> tendons = tendons_with_armature(model);
    if (tendons.empty()) return;
    constexpr double kTime = 1e-5;
    const size_t n = velocities.size();
    std::vector<double> way(n);
    const auto moments_after = [&](double time) {
        for (size_t i = 0; i < n; ++i) way[i] = time * velocities[i];
        return tendon_moments(model, moved_positions(model, positions, way), tendons);
    };
    const std::vector<double> rows = tendon_moments(model, positions, tendons), after = moments_after(kTime),
                              before = moments_after(-kTime);
    for (size_t k = 0; k < tendons.size(); ++k) {
        double length_acceleration = 0;
        for (size_t i = k * n; i < (k + 1) * n; ++i)
            length_acceleration += rows[i] * accelerations[i - k * n] +
                                   (after[i] - before[i]) / (2 * kTime) * velocities[i - k * n];
        for (size_t i = 0; i < n; ++i)
            forces[i] += model.tendons[size_t(tendons[k])].armature * length_acceleration * rows[k * n + i];
    }
}

}  // namespace epode::robots
