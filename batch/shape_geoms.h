// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms of the library for a model's shapes, in no space, and where a copy puts them.
#pragma once

#include <ode/ode.h>

#include "batch/model/asked_pairs.h"

namespace epode::batch {

// 0 where the shape has no volume, or memory ends.
dGeomID make_geom(const robots::Prepared& prepared, const AskedShape& shape);
void put_geom(dGeomID geom, robots::ShapeKind kind, const AskedPose& pose);

}  // namespace epode::batch
