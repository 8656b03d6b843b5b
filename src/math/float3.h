// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A vector of floats, whatever Real is: for quantities relative to a body, and for first guesses.
#pragma once

#include "math/vec.h"

namespace epode {

struct Float3 {
    float x, y, z;
};

inline Float3 narrow(Vec3 a) { return {float(a.x), float(a.y), float(a.z)}; }
inline Vec3 widen(Float3 a) { return {Real(a.x), Real(a.y), Real(a.z)}; }

}  // namespace epode
