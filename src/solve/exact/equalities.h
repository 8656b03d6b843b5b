// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Solves a problem whose rows are all equalities to a few digits, as one step of Newton's method on positions
// needs. The next step measures its error again, so refining each to rounding would be wasted.
#pragma once

#include "base/arena.h"
#include "rows/row_system.h"

namespace epode {

class SymbolicCache;

// Solves J v + C p = c to about 1e-4 of the largest c for every row, whatever bounds it has. `symbolic_cache`
// may be null. False: out of memory.
bool solve_equalities(RowSystem& system, SymbolicCache* symbolic_cache, Arena& arena);

}  // namespace epode
