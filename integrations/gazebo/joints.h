// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints of the library for joints of a file. A degree of freedom is an axis of one of them:
//     revolute   hinge       J(q) = R(a0, q)           prismatic  slider     T(q a0)
//     universal  universal   R(a0, q0) R(a1, q1)       screw      piston     R(a0, q) T(pitch q a0), turn and way coupled
//     revolute2  the same, or a hinge-2 where the axes are not at right angles
//     ball       ball        R(q), q a rotation vector: the axes of an angular motor in mode dAMotorTurn
// The child is the joint's first body, so positions have the file's sign, but those that `sign` turns round.
#pragma once

#include "integrations/gazebo/entities.h"

namespace epode::gazebo {

std::size_t degrees_of(const Joint& joint);

// Makes the library's joint for links that are where all positions are 0. False where there is no memory.
bool make_joint(Joint& joint);
// The same at other positions, after a frame or an axis has changed: the child follows.
bool make_again(Joint& joint);
void destroy_joint(Joint& joint);

double position_of(const Joint& joint, std::size_t degree);
double velocity_of(const Joint& joint, std::size_t degree);
// What springs, dampers and forces have exerted in the last step.
double exerted_force(const Joint& joint, std::size_t degree);
// Moves the child and all that it carries; relative velocities of other joints stay.
void set_position(Joint& joint, std::size_t degree, double value);
void set_velocity(Joint& joint, std::size_t degree, double value);
// For the next step, within the joint's limits of effort.
void set_force(Joint& joint, std::size_t degree, double value);
// From now on, as a motor with the joint's limits of effort; a force ends it.
void set_velocity_command(Joint& joint, std::size_t degree, double value);
// After limits or springs of an axis have changed.
void put_limits(Joint& joint, std::size_t degree);
void put_drive(Joint& joint, std::size_t degree);

// Holds the axis of one joint to another's.
bool couple(Joint& follower, const Joint& leader, const Mimic& mimic);

// The joint's frame on its child, in the world.
Pose frame_of(const Joint& joint);
// What the parent exerts on the child: force and torque about the frame's origin, in the frame's axes.
struct JointWrench {
    Vec force, torque;
};
JointWrench transmitted_wrench(const Joint& joint);

}  // namespace epode::gazebo
