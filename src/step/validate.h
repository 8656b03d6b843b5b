// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What must hold between two calls, whatever a program has done: lists that agree in both directions, finite
// numbers, unit quaternions, boxes that are true, pairs in order. Each part looks at itself (`fault()`); here
// is what lies between parts. Tests ask after every call, debug builds after every step; no argument of a
// program is judged here, those are refused at the border (base/check.h).
#pragma once

#include "collide/space.h"
#include "dynamics/island.h"

namespace epode {

// What is broken, in words; null: nothing. The space's members included, at all depths.
const char* fault_of(const World& world);
const char* fault_of(const Space& space);
// Of the islands as a partition of the active bodies, during a step.
const char* fault_of(const World& world, const Islands& islands, Arena& arena);

}  // namespace epode
