// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Inverse kinematics: positions of a model's joints, within their limits, that bring frames of links to given poses.
// Couplings and loops hold, also where a goal cannot be reached.
#pragma once

#include <cstdint>

#include "robots/model.h"

namespace epode::robots {

// A frame of a link is to be at a pose of the model's world.
struct Goal {
    int link = 0;
    Pose frame;  // in the link's frame
    Pose pose;
    double position_weight = 1, orientation_weight = 1;  // factors of the errors in m and rad
};

struct InverseSettings {
    int max_iterations = 100;  // of a start
    int max_starts = 32;       // the guess first, then positions spread over the limits
    double tolerance = 1e-10;
    std::vector<double> weights;  // of velocities; empty: 1 each; 0: it stays, 2: it moves rather than others
    std::vector<double> posture;  // positions; empty: none
};

struct InverseAnswer {
    std::vector<double> positions;
    double position_error = 0, orientation_error = 0;  // m and rad, the largest of all goals
    double residual = 0;                               // root of the sum of all weighted squares
    bool is_reached = false;
    int iterations = 0, starts = 0;
};

InverseAnswer solve_inverse(const RobotModel& model, const std::vector<double>& guess,
                            const std::vector<Goal>& goals, const InverseSettings& settings);

}  // namespace epode::robots
