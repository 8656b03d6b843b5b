// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How far points of a hull are from the solid: at the middles of free cells inside it. Cells give a distance D to the
// middle of the nearest cell of the surface; the exact distance differs by no more than half a diagonal, so only cells
// within a diagonal of the largest D can have the largest one.
#pragma once

#include "robots/parts/grid.h"
#include "robots/parts/hull.h"

namespace epode::robots {

// m; 0 of a hull without free cells. Where it is certainly above `enough`, any number above that.
double concavity_of(const Hull& hull, const Grid& grid, double enough = HUGE_VAL);

}  // namespace epode::robots
