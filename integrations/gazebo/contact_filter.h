// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which shapes may touch, next to bits and joints: those of one model only if the model says so.
#pragma once

#include "integrations/gazebo/entities.h"

namespace epode::gazebo {

inline Shape* shape_of(dGeomID geom) { return geom ? static_cast<Shape*>(dGeomGetData(geom)) : nullptr; }

// A dContactFilter; the geoms are of shapes.
inline int may_touch(void*, dGeomID one, dGeomID two)
{
    const Model *first = shape_of(one)->link->model, *second = shape_of(two)->link->model;
    return first != second || first->collides_itself;
}

}  // namespace epode::gazebo
