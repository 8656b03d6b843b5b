// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The numbers of independent problems side by side in memory: how data lie, not how they are computed with. A
// lane is never a component of a space vector, so the arithmetic per lane is the scalar formula, operation by
// operation. The number of lanes is the same on every machine, because the packing, and with it the result,
// must not depend on the machine. How many lanes a register holds is the business of simd/pack.h.
#pragma once

#include "math/mat.h"

namespace epode {

// (Lanes of each kind are a type of their own, also where Real is float.)
template <typename T, int n>
struct alignas(n * sizeof(T)) LanesOf {
    using Number = T;
    static constexpr int kCount = n;
    T at[n];

    T operator[](int lane) const { return at[lane]; }
    T& operator[](int lane) { return at[lane]; }
};

inline constexpr int kLanes = 8;
struct Lanes : LanesOf<Real, kLanes> {};

// Floats, whatever Real is: for data relative to bodies, where float is enough and twice as many numbers fit
// a register and a cache line. Sixteen: for long chains of operations. Two chains hide each other's latency.
inline constexpr int kFloatLanes = 8, kBroadLanes = 16;
struct FloatLanes : LanesOf<float, kFloatLanes> {};
struct BroadLanes : LanesOf<float, kBroadLanes> {};

// L: any of these.
template <typename L>
struct LaneVec3Of {
    L x, y, z;

    void set(int lane, Vec3 a)
    {
        using Number = typename L::Number;
        x[lane] = Number(a.x), y[lane] = Number(a.y), z[lane] = Number(a.z);
    }
};

template <typename L>
struct LaneSym3Of {
    L xx, yy, zz, xy, xz, yz;

    void set(int lane, const Sym3& s)
    {
        using Number = typename L::Number;
        xx[lane] = Number(s.xx), yy[lane] = Number(s.yy), zz[lane] = Number(s.zz);
        xy[lane] = Number(s.xy), xz[lane] = Number(s.xz), yz[lane] = Number(s.yz);
    }
};

using LaneVec3 = LaneVec3Of<Lanes>;
using LaneSym3 = LaneSym3Of<Lanes>;
using BroadLaneVec3 = LaneVec3Of<BroadLanes>;
using BroadLaneSym3 = LaneSym3Of<BroadLanes>;

}  // namespace epode
