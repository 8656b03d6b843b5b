// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the public interface tells of a geom's form. Two forms it does not hand out are found by asking: a
// height field by rays from above, a convex geom by Epode's own readers where the library has them; elsewhere
// such a geom has a kind and no surface.
#pragma once

#include <ode/ode.h>

#include "record/file/recording.h"

namespace epode::record {

// A geom inside a dGeomTransform is described in its stead; spaces are not shapes.
Shape shape_of(dGeomID geom);
// Where the geom is on its body, or in the world where it has none.
Pose pose_of(dGeomID geom);

}  // namespace epode::record
