// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What couplings and loops ask of positions: errors c(q) that are 0 where they hold, and C = dc/ds for the velocities s of
// kinematics.h. A coupling is one row; a loop three, where its ends are apart, and three more of a weld, of how they are
// turned: the chord 2 v of E = q1 q2* = (e, v), whose derivative is e (w1 - w2) + (w1 + w2) x v.
// Motions that keep them are those with C s = 0, so the Jacobian of a frame in a constrained model is that of its tree
// times a basis of the null space of C.
#pragma once

#include "robots/model.h"

namespace epode::robots {

std::vector<double> constraint_errors(const RobotModel& model, const std::vector<double>& positions);
// Row by row, as many numbers in each as there are velocities.
std::vector<double> constraint_jacobian(const RobotModel& model, const std::vector<double>& positions);

}  // namespace epode::robots
