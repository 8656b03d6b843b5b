// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The angles of the wheels. With f the wheels' shares of the vehicle's angle delta, their places (x, y) along
// forward and left, and f = b (x - x_0) the straight line through (x, f) by least squares: x_0 is where a
// wheel does not steer, 1/b the wheelbase, and the vehicle turns about the point (x_0, 1/kappa),
//   kappa = b tan(delta)                                   the curvature of the bicycle model
//   delta_i = atan2(kappa (x_i - x_0), 1 - kappa y_i)      Ackermann: all axles point to that point
// and without it delta_i = atan(kappa (x_i - x_0)), the same on both sides (Rajamani, ch. 2; Gillespie,
// Fundamentals of Vehicle Dynamics, ch. 8). If all shares are equal, wheels stay parallel and kappa is 0.
#pragma once

#include "dynamics/forces/vehicle.h"

namespace epode {

// Moves the vehicle's angle towards the driver's, and the wheels' with it.
void steer(Vehicle& vehicle, Real h);

}  // namespace epode
