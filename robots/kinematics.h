// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Jacobians, mass matrix and inverse dynamics of a model's tree, without a world. Couplings and loops do not count
// here; constraints.h has what they ask of velocities.
// Velocities: one of a hinge or slider; three of a ball, its angular velocity in the link's axes; six of a free joint,
// the velocity of the link's origin in the world's axes, then the angular velocity in the link's.
#pragma once

#include <memory>

#include "robots/model.h"

namespace epode::robots {

int velocities_of(const Joint& joint);
int number_of_velocities(const RobotModel& model);

// Positions after a unit of time at these velocities, and a velocity that leads from one position to another: of a ball
// and a free joint the chord 2 sin(angle / 2) in place of the angle.
std::vector<double> moved_positions(const RobotModel& model, const std::vector<double>& positions,
                                    const std::vector<double>& velocities);
std::vector<double> difference(const RobotModel& model, const std::vector<double>& from,
                               const std::vector<double>& to);

// Of a link: its angular velocity and that of its origin, in the world's axes.
struct LinkVelocity {
    Vec angular, linear;
};
std::vector<LinkVelocity> link_velocities(const RobotModel& model, const std::vector<double>& positions,
                                          const std::vector<double>& velocities);

// Six rows, linear then angular, of as many numbers as there are velocities, in the world's axes: of the point of a link,
// given in the link's frame.
std::vector<double> jacobian(const RobotModel& model, const std::vector<double>& positions, int link,
                             Vec point);

// Forces on points of links, in the world's axes, as forces along the velocities' directions.
class PointForces {
  public:
    PointForces(const RobotModel& model, const std::vector<double>& positions);
    ~PointForces();
    PointForces(const PointForces&) = delete;
    PointForces& operator=(const PointForces&) = delete;
    const std::vector<Pose>& poses() const;  // of all links
    void clear();
    void add(int link, Vec point, Vec force);
    void add_torque(int link, Vec torque);
    std::vector<double> along_velocities() const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

// The forces along the velocities' directions that give the accelerations, against gravity, with rotor inertias, without
// springs, dampers and friction.
std::vector<double> inverse_dynamics(const RobotModel& model, const std::vector<double>& positions,
                                     const std::vector<double>& velocities,
                                     const std::vector<double>& accelerations, Vec gravity);
// Square, row by row; rotor inertias on its diagonal.
std::vector<double> mass_matrix(const RobotModel& model, const std::vector<double>& positions);

}  // namespace epode::robots
