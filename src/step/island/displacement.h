// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Finds parts that corrections of positions have carried away without a velocity: relaxing takes the velocity of what sweeps
// correct, so passes that diverge leave no trace but poses metres away; and projections solve linear problems whose answer near a dead
// centre is as far. With d the displacement of a body in the step of h, u = d/h, v0 and v1 its velocities before and after,
//
//   sum m u^2/2  >  sum m (v0^2 + v1^2) + m (3 m/s)^2 + m sum (e_i/h)^2
//
// says so: e_i are the errors of positions and depths, which a step may remove as a whole; those of angles count with the radius of
// the part, as I sum (e_i/h)^2. Parts with springs, and those stepped in joint coordinates, are not judged.
#pragma once

#include "step/island/island_run.h"

namespace epode {

// After a step that was made: parts that have been carried away are set aside, to be stepped in another way. Those of a stepper that iterates as those that have
// diverged; exact solutions without moving poses but by velocities.
void set_displaced_aside(IslandRun& run, bool iterates);

}  // namespace epode
