// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pair functions of any class of convex solids (collide/solid_type.h), by its view: a class has them without
// a line in pairs.inc. The geom is the solid's; the names say which side of the pair it is.
#pragma once

#include "collide/collide.h"

namespace epode {

void solid_solid(const Geom& a, const Pose& A, const Geom& b, const Pose& B, ContactSink& sink);
void solid_plane(const Geom& a, const Pose& A, const Geom& plane, const Pose& P, ContactSink& sink);
void ray_solid(const Geom& ray, const Pose& R, const Geom& b, const Pose& B, ContactSink& sink);
void solid_trimesh(const Geom& a, const Pose& A, const Geom& mesh, const Pose& M, ContactSink& sink);
void solid_heightfield(const Geom& a, const Pose& A, const Geom& field, const Pose& F, ContactSink& sink);

}  // namespace epode
