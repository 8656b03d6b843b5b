// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What an island's step reports of itself: errors at its beginning, the answer's quality, energies before and
// after.
#pragma once

#include <span>

#include "ode/report.h"
#include "solve/solver.h"
#include "step/common/continuous.h"
#include "step/island/positions/projection.h"
#include "step/island/problem/assemble.h"

namespace epode {

void begin_report(const World& world, const Island& island, dIslandStepReport& report);
void report_errors(const IslandWork& work, int part, dIslandStepReport& report);
void report_solution(const IslandWork& work, const SolveReport& solved, dIslandStepReport& report);
// Of a solution with raised inertias: its residual with those of `plain`, which has all velocities after forces. Limits of friction are
// not judged.
void report_raised(const RowSystem& system, std::span<const SolverBody> plain, Arena& arena,
                   std::span<dIslandStepReport> reports);
void report_projection(const ProjectionReport& done, dIslandStepReport& report);
void end_report(const World& world, const Island& island, dIslandStepReport& report);

// Once bodies have been stopped on their way.
void report_stopped(const World& world, const Island& island, const Continuous& continuous,
                    dIslandStepReport& report);

// The step's report from those of its islands.
dWorldStepReport sum_of(std::span<const dIslandStepReport> islands);

}  // namespace epode
