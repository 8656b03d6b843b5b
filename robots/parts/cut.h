// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where to cut a part: the plane across an axis that leaves the least volume of the two hulls together. Volumes are estimated
// from the part's cells: of every slab of cells the extreme corner in each of 50 directions is found once, and the
// hull of one side of a cut is that of the extremes of its slabs, from the first to the cut or from the cut to the last.
#pragma once

#include "robots/parts/box_part.h"

namespace epode::robots {

struct Cut {
    int axis = -1;  // -1: the part is a single cell
    double place = 0;
};

// low and high: of the part's points.
Cut best_cut(const Mesh& mesh, const Grid& grid, const BoxPart& part, Vec low, Vec high);

}  // namespace epode::robots
