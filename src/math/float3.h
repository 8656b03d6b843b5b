// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A vector in floats whatever Real is: for what is relative to a body, or a first guess.
#pragma once

#include "math/vec.h"

namespace epode {

struct Float3 {
    float x, y, z;
};

inline Float3 narrow(Vec3 a) { return {float(a.x), float(a.y), float(a.z)}; }
inline Vec3 widen(Float3 a) { return {Real(a.x), Real(a.y), Real(a.z)}; }

}  // namespace epode
