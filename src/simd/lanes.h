// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers of kLanes independent problems side by side in memory: how data lies, not how it is computed with.
// Lanes are never parts of one vector of space, so the arithmetic per lane is that of the scalar formula,
// operation by operation. kLanes is the same on every machine, because packing, and with it the answer, must
// not depend on it; how many lanes one register takes is the business of simd/vectors.h.
#pragma once

#include "math/mat.h"

namespace epode {

inline constexpr int kLanes = 8;

struct alignas(kLanes * sizeof(Real)) Lanes {
    using Number = Real;
    Real at[kLanes];

    Real operator[](int lane) const { return at[lane]; }
    Real& operator[](int lane) { return at[lane]; }
};

// L: Lanes, or the FloatLanes of simd/float_lanes.h.
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

}  // namespace epode
