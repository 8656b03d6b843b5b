// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Eight floats side by side, whatever Real is: for data relative to bodies, where float is enough and twice
// as many numbers fit a register and a cache line. As with Lanes, every lane is an independent problem and
// the number of lanes is the same on every machine.
#pragma once

#include "simd/lanes.h"

namespace epode {

inline constexpr int kFloatLanes = 8;

struct alignas(kFloatLanes * sizeof(float)) FloatLanes {
    using Number = float;
    float at[kFloatLanes];

    float operator[](int lane) const { return at[lane]; }
    float& operator[](int lane) { return at[lane]; }
};

// Sixteen: for long chains of operations. Two chains hide each other's latency.
inline constexpr int kBroadLanes = 16;

struct alignas(kBroadLanes * sizeof(float)) BroadLanes {
    using Number = float;
    float at[kBroadLanes];

    float operator[](int lane) const { return at[lane]; }
    float& operator[](int lane) { return at[lane]; }
};

using BroadLaneVec3 = LaneVec3Of<BroadLanes>;
using BroadLaneSym3 = LaneSym3Of<BroadLanes>;

}  // namespace epode
