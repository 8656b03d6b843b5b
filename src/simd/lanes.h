// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers of kLanes independent problems side by side in memory: how data lies, not how it is computed with.
// Lanes are never parts of one vector of space, so the arithmetic per lane is that of the scalar formula,
// operation by operation. kLanes is the same on every machine, because packing, and with it the answer, must
// not depend on it; how many lanes one register takes is the business of simd/registers.h.
#pragma once

#include "math/mat.h"

namespace epode {

inline constexpr int kLanes = 8;

struct alignas(kLanes * sizeof(Real)) Lanes {
    Real at[kLanes];

    Real operator[](int lane) const { return at[lane]; }
    Real& operator[](int lane) { return at[lane]; }
};

struct LaneVec3 {
    Lanes x, y, z;

    void set(int lane, Vec3 a) { x[lane] = a.x, y[lane] = a.y, z[lane] = a.z; }
};

struct LaneSym3 {
    Lanes xx, yy, zz, xy, xz, yz;

    void set(int lane, const Sym3& s)
    {
        xx[lane] = s.xx, yy[lane] = s.yy, zz[lane] = s.zz;
        xy[lane] = s.xy, xz[lane] = s.xz, yz[lane] = s.yz;
    }
};

}  // namespace epode
