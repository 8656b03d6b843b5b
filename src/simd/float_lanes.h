// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Eight floats side by side, whatever Real is: for data relative to bodies, where float is enough and twice
// as many numbers fit a register and a cache line. As with Lanes, lanes are independent problems and their
// number is the same on every machine.
#pragma once

#include "math/mat.h"

namespace epode {

inline constexpr int kFloatLanes = 8;

struct alignas(kFloatLanes * sizeof(float)) FloatLanes {
    float at[kFloatLanes];

    float operator[](int lane) const { return at[lane]; }
    float& operator[](int lane) { return at[lane]; }
};

struct FloatLaneVec3 {
    FloatLanes x, y, z;
};

struct FloatLaneSym3 {
    FloatLanes xx, yy, zz, xy, xz, yz;

    void set(int lane, const Sym3& s)
    {
        xx[lane] = float(s.xx), yy[lane] = float(s.yy), zz[lane] = float(s.zz);
        xy[lane] = float(s.xy), xz[lane] = float(s.xz), yz[lane] = float(s.yz);
    }
};

}  // namespace epode
