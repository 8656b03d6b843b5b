// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The settings of single objects in the structure of a world (state/world_structure.h). What states have is
// left out: poses, velocities, switches that steps change.
#pragma once

#include "collide/shape_stream.h"
#include "dynamics/world.h"

namespace epode {

void structure_of_settings(World& world, StructureStream& stream);
void structure_of_body(Body& body, StructureStream& stream);
// Without its class, its space and its shape.
void structure_of_geom(Geom& geom, StructureStream& stream);

void structure_of_pose(Real* position, Real* rotation, StructureStream& stream);  // in ODE's layout

}  // namespace epode
