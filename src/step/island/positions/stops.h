// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints that are beyond their stops, brought back without a speed ("split impulses", Guendelman, Bridson & Fedkiw, 2003).
//
// ODE's stop asks for J v = erp/h e: from 0.25 rad beyond it throws a joint at 5 rad/s in steps of 10 ms and at 50 in steps of 1 ms, and
// nothing takes the speed away. Where the world bounds correcting velocities (dWorldSetContactMaxCorrectingVel, as presets do)
// velocities only keep such a stop from opening further, J v >= 0, and the poses are moved after the step by the least dx
//
//   minimise  dx^T M dx / 2   subject to   J dx = 0 for what holds joints,   J dx >= min(erp e, h v_max) for stops, 0 for contacts
//
// to first order, and all of it at most as far as arms of 10 m move; what that leaves is the next step's. Small errors keep their velocity: below kSlow nobody is thrown.
#pragma once

#include "step/island/problem/assemble.h"
#include "tasks/tasks.h"

namespace epode {

// Takes the correction of stops that would throw out of the velocities of the step. False: there are none.
bool leave_stops_to_poses(const World& world, RowSystem& system);

// Solves the problem of a closing with what the stepper solves its steps with. False: out of memory.
using SolveStops = bool (*)(RowSystem& system, const World& world, const Tasks& tasks, Arena& arena);

// The island's poses have been advanced by h. Out of memory: all stays.
void close_stops(const World& world, const IslandWork& work, SolveStops solve, const Tasks& tasks,
                 Arena& arena);

}  // namespace epode
