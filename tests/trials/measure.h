// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What bodies have: energy, momentum, and how far joints are open. From what the public functions return.
#pragma once

#include "stage.h"

namespace epode::trials {

std::vector<dBodyID> bodies_of(dWorldID world);
double kinetic_energy(dBodyID body);
double kinetic_energy(const Stage& stage);
double potential_energy(const Stage& stage);  // -sum m g.x
inline double energy(const Stage& stage) { return kinetic_energy(stage) + potential_energy(stage); }
Vec momentum(const Stage& stage);
Vec angular_momentum(dBodyID body);  // about the origin
// The same if the body lay there.
Vec angular_momentum(dBodyID body, Vec at, Turn q);
Vec angular_momentum(const Stage& stage);
double total_mass(const Stage& stage);
// How far the anchors of a ball joint or hinge are apart.
double gap(dJointID joint);
// Of the angle between two directions, degrees.
double degrees_between(Vec a, Vec b);
inline double degrees(double radians) { return radians * 180 / kPi; }
inline double across(Vec v) { return std::hypot(v.x, v.y); }  // horizontal part

}  // namespace epode::trials
