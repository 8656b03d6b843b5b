// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A body of parts and its break. With masses m_i, centres r_i from the body's own and inertias I_i about these,
//   m = sum m_i,   sum m_i r_i = 0,   I = sum I_i + m_i (r_i^2 1 - r_i r_i^T),
// pieces that go on with v_i = v + w x r_i and w_i = w have together its momentum, m v, and its angular momentum, I w.
#pragma once

#include "assemblies/fracture_parts.h"
#include "dynamics/world.h"

namespace epode {

inline constexpr const char* kStrangers = "a body with geoms that are no parts";

// Where and how far: parts within `radius` of `place` come off, and the part `struck` (-1: none) in any case.
struct Break {
    Vec3 place;
    Real radius;
    int struck;
};

// Puts the geoms on a new body of the world. Null, and *fault says why, with nothing changed.
dBodyID unite_parts(dWorldID world, Parts parts, const char** fault);
// Returns how many bodies it has become; 0: it does not break, or *fault says why.
int break_body(Parts parts, dBodyID body, const Break& how, const char** fault);

}  // namespace epode
