// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Approximate convex decomposition: hulls whose union contains a solid S and no point farther from S than a tolerance.
//   part          what a box with sides across the axes has of S; its hull H is exact (box_part.h)
//   concavity     max over x in H of dist(x, S), at the free cells of a grid whose middle is in H
//   cut           the part of the largest concavity is cut, by the plane that leaves the least volume of the two hulls
//                 together; since the volume of S in them does not depend on the plane, that is the least surplus
//   merging       two parts become one if the hull of both is within the tolerance, or if there are too many
// Cutting by concavity and merging are those of Mamou and Ghorbel, "A simple and efficient approach for 3D mesh approximate
// convex decomposition", 2009; the distance to the solid as the measure is that of Wei, Liu, Ling and Su, "Approximate convex
// decomposition for 3D meshes with collision-aware concavity and tree search", 2022. Rejected: their exact meshes of parts,
// which need closed manifolds and triangulated sections. A wall thinner than a cell has no inside that can be filled by
// mistake; an opening narrower than a cell is closed.
#pragma once

#include <string>

#include "robots/model.h"
#include "robots/parts/hull.h"
#include "robots/parts/settings.h"

namespace epode::robots {

struct Decomposition {
    std::vector<Hull> hulls;
    double tolerance = 0;  // m, that was searched for
    double surplus = 0;    // m: no measured point of the hulls is farther from the solid
    double uncovered =
        0;            // m: no point of the solid is farther outside the hulls; 0 unless vertices were limited
    double cell = 0;  // m, of the grid of measurements
    bool is_closed = false;  // false: holes wider than a cell made the mesh a surface
};

// False and a problem for a mesh without triangles, with numbers that are not finite or all in one plane.
bool decompose(const Mesh& mesh, const PartSettings& settings, Decomposition& out, std::string& problem);

}  // namespace epode::robots
