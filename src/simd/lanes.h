// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The numbers of kLanes independent problems side by side in memory: how data lie, not how they are computed
// with. A lane is never a component of a space vector, so the arithmetic per lane is the scalar formula,
// operation by operation. kLanes is the same on every machine, because the packing, and with it the result,
// must not depend on the machine. How many lanes a register holds is the business of simd/vectors.h.
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
