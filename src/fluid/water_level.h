// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The surface of a fluid at a geom. A surface function gives heights over the fluid's plane, and the geom sees a plane. Of a box with
// half extents e1, e2 along two directions of the plane the mean height and the mean slopes come from Gauss' four places
// +-e1/sqrt(3), +-e2/sqrt(3), which integrate cubic surfaces exactly over a rectangle: for a wave of wave number k over half a
// length e the mean is wrong by (k e)^4/270 of the wave's height, the slope by (k e)^2/15. (The tangent plane at the middle is wrong
// by (k e)^2/6 and (k e)^2/10.) Larger bodies should have several geoms.
#pragma once

#include "dynamics/forces/fluid.h"
#include "fluid/floating_geom.h"

namespace epode {

// The flat surface, or what the function says; world frame. Calls a function of the program.
WaterPlane level_at(const Fluid& fluid, const FloatingGeom& geom);

// Is the place, the centre of what is submerged, in the volume of the fluid?
bool holds(const Fluid& fluid, Vec3 place);

// Calls a function of the program.
Vec3 current_at(const Fluid& fluid, Vec3 place);

}  // namespace epode
