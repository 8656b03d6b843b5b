// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// 16-byte vectors of Real: what every machine that we serve has in one register (SSE2, NEON). Lanes are
// independent problems, never parts of one vector of space, so the arithmetic per lane is that of the scalar
// formula, operation by operation, and the bits are the same on every compiler. Wider registers would be
// faster where they exist, but then the packing, and with it the answer, would depend on the machine.
#pragma once

#include "math/mat.h"

namespace epode {

typedef Real Lanes __attribute__((vector_size(16)));
inline constexpr int kLanes = 16 / int(sizeof(Real));

// The second argument wins when the first is not a number.
inline Lanes at_most(Lanes bound, Lanes x) { return bound < x ? bound : x; }
inline Real at_most(Real bound, Real x) { return bound < x ? bound : x; }
inline Lanes at_least(Lanes bound, Lanes x) { return bound > x ? bound : x; }

struct LaneVec3 {
    Lanes x, y, z;

    Vec3 get(int lane) const { return {x[lane], y[lane], z[lane]}; }
    void set(int lane, Vec3 a) { x[lane] = a.x, y[lane] = a.y, z[lane] = a.z; }
};

inline LaneVec3 operator+(const LaneVec3& a, const LaneVec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline LaneVec3 operator-(const LaneVec3& a, const LaneVec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline LaneVec3 operator*(Lanes s, const LaneVec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Lanes dot(const LaneVec3& a, const LaneVec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline LaneVec3 cross(const LaneVec3& a, const LaneVec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct LaneSym3 {
    Lanes xx, yy, zz, xy, xz, yz;

    void set(int lane, const Sym3& s)
    {
        xx[lane] = s.xx, yy[lane] = s.yy, zz[lane] = s.zz;
        xy[lane] = s.xy, xz[lane] = s.xz, yz[lane] = s.yz;
    }
};

inline LaneVec3 operator*(const LaneSym3& s, const LaneVec3& a)
{
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}

}  // namespace epode
