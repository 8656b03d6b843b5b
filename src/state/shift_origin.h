// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Another origin for a world: all that lies in it moves by one vector, and nothing moves against anything else.
// Anything that is relative to a body or a geom stays as it is; so do anchors of contacts on planes, if the vector is a
// multiple of their lattice (contacts/manifold_points.h). Otherwise such pairs are collided again and inherit their
// impulses.
#pragma once

#include "collide/space.h"
#include "dynamics/world.h"

namespace epode {

// `space`: the outermost one of the geoms without bodies; null: none. Null: done; else why not, with nothing changed.
[[gnu::cold]] const char* shift_origin(World& world, Space* space, Vec3 by);

}  // namespace epode
