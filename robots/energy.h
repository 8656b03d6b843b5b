// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Energies of a built robot, J, as MuJoCo counts them: kinetic with the armatures; potential of gravity, 0 at the world's
// origin, and of the springs of joints and tendons.
#pragma once

#include "robots/build.h"

namespace epode::robots {

double kinetic_energy(const Robot& robot);
double potential_energy(const Robot& robot, Vec gravity);

}  // namespace epode::robots
