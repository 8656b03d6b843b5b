// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The shapes that are no handful of numbers: triangles in the geom's frame.
#pragma once

#include <ode/ode.h>

#include "record/file/recording.h"

namespace epode::record {

Shape mesh_surface(dGeomID mesh);
// Without triangles where the library does not tell (libraries other than Epode's).
Shape convex_surface(dGeomID convex);
// Of a class beyond ODE's, if it is a convex solid: its surface, as a convex form; else of unknown kind.
Shape solid_surface(dGeomID solid);
// Sampled on a grid of 64 x 64 cells; without triangles where the field has no end (it repeats itself) or is
// turned by something else than right angles.
Shape height_field_surface(dGeomID field);

}  // namespace epode::record
