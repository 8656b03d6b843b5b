// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How a bike holds itself, as its rider does. On the path that it really takes, with the speed v and the yaw
// rate r, the resultant of gravity and inertia passes through its wheels at the lean
//   tan(phi_0) = -v r / g                                 phi about forward, to the right
// A moment about forward leads it there, critically damped with the frequency w_n:
//   M = J (w_n^2 (phi_0 - phi) - 2 w_n phi') / (1 + 2 w_n h + (w_n h)^2),   J = I + m l^2, about the ground
// implicit in the motion that it gives, and at most J 0.8 g / l: to roll faster the tyres would have to move the wheels sideways
// with more than they hold, and the bike would fall. In a steady curve it is 0: the tyres alone hold the bike (Cossalter,
// Motorcycle Dynamics, ch. 4, with thin tyres). A rider leans by steering against the curve; the moment stands for
// that, and for the feet at rest, and acts on the ground the other way.
#pragma once

#include "vehicles/wheel_forces.h"

namespace epode {

// The lean now, by gravity; 0 without.
Real lean_of(const Body& body, const VehicleFrame& frame);

// The moment; 0 in the air.
Real lean_moment(const Body& body, const WheelForces& forces, Real h);

}  // namespace epode
