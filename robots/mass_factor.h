// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// L of M = L L', the mass matrix of a model at a position: inverse masses along directions of its velocities.
#pragma once

#include "robots/model.h"

namespace epode::robots {

class MassFactor {
  public:
    explicit MassFactor(const RobotModel& model);  // at its reference position
    MassFactor(const RobotModel& model, const std::vector<double>& positions);
    // False where M is not positive, or the model does not move.
    bool is_good() const { return is_good_; }
    size_t size() const { return size_; }
    // b' M^-1 b = |L^-1 b|^2, of as many numbers as there are velocities.
    double inverse_mass(const double* b) const;
    // L^-1 b: of two such directions the product is a' M^-1 b.
    std::vector<double> halfway(const double* b) const;
    // Of a joint's velocities the mean.
    double inverse_mass(const RobotModel& model, int joint) const;

  private:
    size_t size_;
    std::vector<double> lower_;
    bool is_good_;
};

// The first velocity of a joint.
int velocity_of(const RobotModel& model, int joint);

}  // namespace epode::robots
