// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What of a solid mesh is in a box: the points whose hull is that of the part. The part's boundary is the mesh's triangles,
// clipped to the box, and what the sides of the box cut out of the solid. A side that no cut made is infinitely far away.
// Extreme points of the second kind are corners of the first or corners of the box inside the solid: so the hull is exact,
// and cross sections are never triangulated.
#pragma once

#include "robots/parts/grid.h"

namespace epode::robots {

struct CutBox {
    Vec low{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, high{HUGE_VAL, HUGE_VAL, HUGE_VAL};
};

struct BoxPart {
    CutBox box;
    std::vector<std::uint32_t> triangles;  // that reach into the box
};

// The triangles of `from` that reach more than `thin` into a box inside that of `from`.
BoxPart cut_out(const Mesh& mesh, const BoxPart& from, const CutBox& box, double thin);
std::vector<Vec> points_of(const Mesh& mesh, const Grid& grid, const BoxPart& part, double thin);

}  // namespace epode::robots
