// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Impulses that the program or a character gives to bodies between two steps: the velocities change at once.
//   v += J / m,  w += R I^-1 R^T (r x J + L)
// J: impulse (N s), L: angular impulse (N m s), r: arm from the centre of mass. Kinematic bodies keep theirs.
#pragma once

#include "dynamics/body.h"

namespace epode {

// R I^-1 R^T x, in the world.
Vec3 turned_by(const Body& body, Vec3 angular_impulse);
// The velocity along the unit vector d that a unit impulse along it gives to a point: d . K d.
Real yielding(const Body& body, Vec3 arm, Vec3 d);
// Changes the velocities and no more.
void add_impulse(Body& body, Vec3 impulse, Vec3 arm, Vec3 angular = {});

}  // namespace epode
