// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sine, cosine, arc tangent and arc cosine with the same bits on every machine: libm implementations differ
// in the last place, which a hash over a thousand steps would show.
#pragma once

#include "base/config.h"

namespace epode {

Real sin(Real x);
Real cos(Real x);
Real atan2(Real y, Real x);  // in [-pi, pi]; atan2(0, 0) = 0
Real acos(Real x);           // argument clamped to [-1, 1]
Real sinc(Real x);           // sin(x)/x, 1 at 0

}  // namespace epode
