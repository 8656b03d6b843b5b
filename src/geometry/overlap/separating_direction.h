// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A direction that separates two convex solids, if there is one: any will do, but one along which they are
// about as far apart as they are serves longer. The nearest point to the origin of C = { x - y : x in a, y in b }
// is approached as in GJK (gjk.h), but roughly: on three points at most besides the newest, and no further
// than to a plane that keeps the origin out by half of what could be. Radii count: the plane must be beyond
// them.
#pragma once

#include "geometry/convex_view.h"

namespace epode {

// From b to a, of length 1, more than `hair` apart; zero when none has been found, which proves nothing.
// `guess`: where to begin.
Vec3 separating_direction(const ConvexView& a, const ConvexView& b, Vec3 guess, Real hair);

}  // namespace epode
