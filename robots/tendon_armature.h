// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Inertia of what tendons drive (MJCF's armature b): half b (dL/dt)^2 of energy, so that with the row J of dL/ds, s being the
// velocities, the mass matrix has b J' J more, and inverse dynamics b J' (J ds/dt + dJ/dt s), dJ/dt s being the difference of J s
// over a short way along s.
#pragma once

#include "robots/model.h"

namespace epode::robots {

void add_armatures(const RobotModel& model, const std::vector<double>& positions,
                   std::vector<double>& matrix);
void add_armature_forces(const RobotModel& model, const std::vector<double>& positions,
                         const std::vector<double>& velocities, const std::vector<double>& accelerations,
                         std::vector<double>& forces);

}  // namespace epode::robots
