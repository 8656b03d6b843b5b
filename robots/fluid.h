// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces of a medium, as MuJoCo's documentation has them ("Computation", "Fluid forces", inertia model). A link resists as the box that
// has its mass m and moments I: half sides r_x = sqrt(3 (I_y + I_z - I_x) / 2 m) and so on. Along each of the box's axes
//     f_i = -(2 rho r_j r_k |v_i| + 6 pi beta r) v_i
//     g_i = -(rho r_i (r_j^4 + r_k^4) |w_i| / 2 + 8 pi beta r^3) w_i
// with the density rho, the viscosity beta, the mean half side r, the velocity v of the box's centre less the wind, and the angular
// velocity w, in the box's axes.
// A step of size h with f = -c v at its beginning would turn v round where h c > m. So c is at most m / h, and of a torque I / h:
// then, M being the sum of J^T diag(m, I) J, no eigenvalue of h M^-1 J^T diag(c) J is above 1: whatever the joints, a step takes
// away at most the motion that there is. Weaker c are left as they are, so speeds at which other forces are in balance with the
// medium are exact at any h; the implicit Euler step of a lone body, c / (1 + h c / m), would change them.
#pragma once

#include "robots/model.h"

namespace epode::robots {

// Of all links with a mass, where the model has a medium.
void make_fluid_boxes(RobotModel& model);

// Force and torque about the box's centre, in its axes, as the velocities are. h: the step's size, 0: of a step without size.
struct FluidForce {
    Vec force, torque;
};
FluidForce fluid_force(const FluidBox& box, const Medium& medium, Vec velocity, Vec angular, double h);

// Along the velocities' directions.
std::vector<double> fluid_forces(const RobotModel& model, const std::vector<double>& positions,
                                 const std::vector<double>& velocities);

}  // namespace epode::robots
