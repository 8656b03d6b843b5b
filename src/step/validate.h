// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Invariants between two calls of the program: lists that agree in both directions, finite numbers, unit
// quaternions, correct boxes, pairs in order. Each component checks itself (`fault()`); this file checks what
// several components share. Tests check after every call, debug builds after every step. The program's
// arguments are checked elsewhere, at the public functions (base/check.h).
#pragma once

#include "collide/space.h"
#include "dynamics/island.h"

namespace epode {

// The first broken invariant, in words; null: none. A space includes its members at all depths.
const char* fault_of(const World& world);
const char* fault_of(const Space& space);
// During a step: are the islands a partition of the active bodies?
const char* fault_of(const World& world, const Islands& islands, Arena& arena);

}  // namespace epode
