// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The rule for two balls, to which capsules reduce: the normal is along the line of the centres, the contact
// in the middle of the overlap. If the centres are equal up to rounding, `fallback()` returns the normal; it
// is not called otherwise.
#pragma once

#include "collide/contact_sink.h"
#include "geometry/closest.h"

namespace epode {

template <typename Fallback>
bool ball_contact(Vec3 a, Real ra, Vec3 b, Real rb, Fallback&& fallback, ContactPoint& out)
{
    const Vec3 apart = a - b;
    const Real distance = length(apart);
    if (distance > ra + rb) return false;
    const Real noise = 16 * kEpsilon * (max_component(abs(a)) + max_component(abs(b)));
    const bool same = !(distance > noise);
    out.normal = same ? fallback() : direction_of(apart, distance, {1, 0, 0});
    out.depth = ra + rb - distance;
    out.position = same ? a : a + Real(0.5) * (rb - ra - distance) * out.normal;
    return true;
}

}  // namespace epode
