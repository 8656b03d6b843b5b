// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Who is so fast that a step takes it through the other one: where the two will be at the end they do not touch, or from behind. A ball of
// 10 cm that has fallen 0.5 m passes half of its size in a sixtieth of a second, and a mesh has no inside that would hold it.
//   solids   each part of the way that is no longer than both together are thick is looked at
//   meshes   the way of the solid's middle is a ray, which ends on the triangle that it goes through; there the solid is by half of what it is
//            thick on the near side
// Height fields are solid ground, and planes too: nothing is lost below them. What is small and yet faster is for continuous geoms.
#pragma once

#include "contacts/ahead/far_points.h"

namespace epode {

// A pair now and after a step.
struct PairWay {
    PlacedGeom first, second;
    Pose first_soon, second_soon;
};

// Half of what the thinner one of the two is thick; a surface is ground, and none of the two.
Real thickness(const Geom& first, const Geom& second);

// Whether the two may pass through each other on a way of that length.
bool may_pass(const Geom& first, const Geom& second, Real way);

// Of two solids: how many parts of the way to look at, each no longer than they are thick.
int parts_of_way(const Geom& first, const Geom& second, Real way);

// The share of the step after which a solid has met the mesh that its middle will have crossed; 1: it does not cross it.
[[gnu::cold]] Real share_before_crossing(const PairWay& pair);

}  // namespace epode
