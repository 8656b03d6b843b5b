// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Muscles as MuJoCo's documentation has them ("Modeling", muscles): with the length l and its rate v of what it moves, times the gear,
//     L0 = (length_high - length_low) / (high - low),   L = low + (l - length_low) / L0,   V = v / (L0 fastest)
//     force = -F (FL(L) FV(V) act + FP(L))
//   FL   a bump over shortest ... 1 ... longest, of quadratic pieces
//   FV   (V + 1)^2 while it shortens, 0 from V = -1 on; up to `eccentric` while it lengthens
//   FP   from L = 1 on quadratic to `passive`/2 at the middle to `longest`, then straight
// Its activation follows the control u, clamped to 0 ... 1:  act' = (u - act) / T,  T = T1 (1/2 + 3/2 act) while it rises and
// T2 / (1/2 + 3/2 act) while it falls, or, with a width s, a smooth step between the two over |u - act| <= s/2.
#pragma once

#include "robots/model.h"

namespace epode::robots {

// What a muscle exerts, before the gear.
double muscle_force(const Muscle& muscle, double act, double length, double rate);
// act' at a control.
double muscle_rate(const Activation& filter, double act, double control);

}  // namespace epode::robots
