// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms of the library for a model's shapes.
#pragma once

#include <ode/ode.h>

#include "robots/build.h"

namespace epode::robots {

// Of how many geoms a shape consists: a mesh of its hulls. Plates and lines have none, and touch nothing.
int parts_of(const Prepared& prepared, const Shape& shape);

// In its own axes, a plane at z = 0. The space may be 0. 0 where memory ends, or of triangles that could not be read.
dGeomID make_geom(dSpaceID space, const Prepared& prepared, const Shape& shape, int part);
// Of a shape's frame the geom's: ODE's height fields have y up, and z towards the shape's -y.
Pose geom_pose(const Shape& shape);
// A plane's normal is z of `at`.
void put_plane(dGeomID plane, const Pose& at);

}  // namespace epode::robots
