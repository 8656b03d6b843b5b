// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A solid of any class as a shape of its own, where algorithms are compiled for each shape: those on meshes
// and height fields. The radius around the core is made part of the solid.
#pragma once

#include "collide/solid_type.h"

namespace epode {

struct AnySolid {
    explicit AnySolid(const Geom& geom) : core(solid_view(geom, {})), round(geom.type->solid->round) {}
    ConvexView core;  // in the geom's frame
    bool round;
};

// The solid must stay while the view is used.
ConvexView view_of(const AnySolid& solid, const Pose& pose);

}  // namespace epode
