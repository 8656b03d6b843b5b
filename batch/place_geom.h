// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where a copy puts the geom of a model's shape.
#pragma once

#include <ode/ode.h>

#include "batch/model/asked_pairs.h"

namespace epode::batch {

void put_geom(dGeomID geom, robots::ShapeKind kind, const AskedPose& pose);

}  // namespace epode::batch
