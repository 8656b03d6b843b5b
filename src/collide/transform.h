// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The geom transform, an old way to place a geom relative to a body: it holds one geom, whose pose is then
// meant in the transform's frame. It collides as that geom placed at transform * geom.
#pragma once

#include "collide/geom.h"
#include "ode/collision.h"

namespace epode {

struct TransformGeom : Geom {
    explicit TransformGeom(const GeomType& transform_type) : Geom(transform_type) {}
    Geom* inner = nullptr;
    TransformGeom* next_holder = nullptr;  // further transforms that hold the same geom
    int cleanup = 0;                       // whether the geom dies with the transform
    int info = 0;                          // whether contacts name the transform
};

// Null if it is none.
TransformGeom* as_transform(Geom& geom);

// A ray, or a transform that holds one: it measures, but carries, stops and pushes nothing.
inline bool is_ray(const Geom& geom)
{
    const Geom* at = &geom;
    while (at && at->type->number == dGeomTransformClass) at = static_cast<const TransformGeom*>(at)->inner;
    return at && at->type->number == dRayClass;
}

// Lets go the present geom, without destroying it, and takes another one or none.
void set_transform_geom(TransformGeom& transform, Geom* inner);

// Puts a geom elsewhere for the time of a scope: user functions read the pose with dGeomGetPosition. Where no such
// function is called, the pose lies on the stack.
class PlacedElsewhere {
  public:
    PlacedElsewhere(Geom& geom, const Pose& pose, bool called);
    ~PlacedElsewhere();
    PlacedElsewhere(const PlacedElsewhere&) = delete;
    PlacedElsewhere& operator=(const PlacedElsewhere&) = delete;

  private:
    struct Place {
        Real position[4], rotation[12];
    };
    static void put_back(void* geom, const void* place, std::size_t size);

    Geom& geom_;
    const Real *old_position_, *old_rotation_;
    Aabb old_box_;
    bool old_stale_;
    Place here_;
    Place* const own_;  // not on the stack; null: none
    CallGuard guard_;
};

}  // namespace epode
