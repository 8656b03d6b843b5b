// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF's soft contacts and limits as springs. MuJoCo's documentation ("Solver parameters") has, for a constraint violated by
// r at the speed v, a0 being the acceleration without it,
//   a1 + d (b v + k r) = (1 - d) a0        d(r) impedance, k = d/(d1 T z)^2, b = 2/(d1 T), d1 the largest impedance,
//                                          T time constant, z damping ratio; or k = d K/d1^2, b = B/d1 given as -K, -B
// so that the force on an inverse mass A is (a1 - a0)/A = -(k r + b v + a1)/R with R = A (1 - d)/d: a spring of stiffness
// k/R, a damper b/R, and an inertia 1/R, which is left out: it changes how a constraint yields, not where. That stiffness
// grows with r and ours does not; ours is that at which a usual load of the robot is carried: half its weight W for contacts,
// W/2 at the radius of gyration of what a joint carries for limits.
//   A of a contact   the mean of the three directions of a link's centre, in the reference pose; of the world 0
//   A of a limit     of the joint's coordinate
#pragma once

#include <vector>

#include "robots/model.h"

namespace epode::robots {

struct Spring {
    double stiffness = 0, damping = 0;  // 0: rigid
};

// Where the constraint of inverse mass A carries the load; rigid where nothing is stated or A is 0.
Spring spring_of(const Softness& softness, double inverse_mass, double load);

// Of all shapes and limits of a model that state a softness.
class Springs {
  public:
    explicit Springs(const RobotModel& model);
    Spring of_shape(int link, const Shape& shape) const;
    Spring of_pair(int link1, int link2, const Softness& softness) const;
    Spring of_limit(const RobotModel& model, int joint) const;

  private:
    double weight_ = 0;
    std::vector<double> of_links_, of_velocities_;  // inverse masses; empty where nothing is soft
    std::vector<double> carried_;                   // masses, by link
};

}  // namespace epode::robots
