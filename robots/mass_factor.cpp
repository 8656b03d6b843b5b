// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mass_factor.h.
#include "robots/mass_factor.h"

#include "robots/kinematics.h"

namespace epode::robots {

namespace {

// Row by row, in place; false where M is not positive.
bool factor(std::vector<double>& m, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j) {
            double sum = m[i * n + j];
            for (size_t k = 0; k < j; ++k) sum -= m[i * n + k] * m[j * n + k];
            if (i == j && !(sum > 0)) return false;
            m[i * n + j] = i == j ? std::sqrt(sum) : sum / m[j * n + j];
        }
    return true;
}

}  // namespace

int velocity_of(const RobotModel& model, int joint)
{
    int before = 0;
    for (int i = 0; i < joint; ++i) before += velocities_of(model.joints[size_t(i)]);
    return before;
}

MassFactor::MassFactor(const RobotModel& model) : MassFactor(model, reference_positions(model)) {}

MassFactor::MassFactor(const RobotModel& model, const std::vector<double>& positions)
    : size_(size_t(number_of_velocities(model))), lower_(mass_matrix(model, positions))
{
    is_good_ = size_ > 0 && factor(lower_, size_);
}

std::vector<double> MassFactor::halfway(const double* b) const
{
    std::vector<double> y(size_);
    for (size_t i = 0; i < size_; ++i) {
        y[i] = b[i];
        for (size_t k = 0; k < i; ++k) y[i] -= lower_[i * size_ + k] * y[k];
        y[i] /= lower_[i * size_ + i];
    }
    return y;
}

double MassFactor::inverse_mass(const double* b) const
{
    double out = 0;
    for (double y : halfway(b)) out += y * y;
    return out;
}

double MassFactor::inverse_mass(const RobotModel& model, int joint) const
{
    const int count = velocities_of(model.joints[size_t(joint)]);
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        std::vector<double> unit(size_, 0);
        unit[size_t(velocity_of(model, joint) + i)] = 1;
        sum += inverse_mass(unit.data());
    }
    return sum / count;
}

}  // namespace epode::robots
