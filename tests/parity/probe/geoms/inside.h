// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Proof of overlap by example: a point inside both geoms, found by sampling.
//
// When one library reports a contact and the other none, such a point tells which is right without asking
// either. The inside tests are written here from the shapes' definitions and use only pose and size getters.
#pragma once

#include "geoms.h"

namespace parity {

// True if a point lies deeper than the margin in both; false proves nothing. Rays have no inside.
bool share_a_point(const Placed& a, const Placed& b, double margin, Random& random);

}  // namespace parity
