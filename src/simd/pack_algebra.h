// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vectors of space, symmetric matrices and quaternions in lanes: each component is a P, a Pack or Quad of
// numbers of independent problems. The order of operations is that of math/vec.h, math/mat.h and math/pose.h,
// so lanes give the bits of the scalar formulas.
#pragma once

#include "simd/lanewise.h"

namespace epode {
namespace {

template <typename P>
struct Vec3Of {
    P x, y, z;
};

template <typename P>
EPODE_LANEWISE Vec3Of<P> operator+(const Vec3Of<P>& a, const Vec3Of<P>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <typename P>
EPODE_LANEWISE Vec3Of<P> operator-(const Vec3Of<P>& a, const Vec3Of<P>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <typename P>
EPODE_LANEWISE Vec3Of<P> operator*(const P& s, const Vec3Of<P>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

template <typename P>
EPODE_LANEWISE P dot(const Vec3Of<P>& a, const Vec3Of<P>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename P>
EPODE_LANEWISE Vec3Of<P> cross(const Vec3Of<P>& a, const Vec3Of<P>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename P>
struct Sym3Of {
    P xx, yy, zz, xy, xz, yz;
};

template <typename P>
EPODE_LANEWISE Vec3Of<P> operator*(const Sym3Of<P>& s, const Vec3Of<P>& a)
{
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}

template <typename P>
struct Mat3Of {
    Vec3Of<P> row0, row1, row2;
};

template <typename P>
EPODE_LANEWISE Vec3Of<P> operator*(const Mat3Of<P>& m, const Vec3Of<P>& a)
{
    return {dot(m.row0, a), dot(m.row1, a), dot(m.row2, a)};
}

template <typename P>
EPODE_LANEWISE Vec3Of<P> transposed_times(const Mat3Of<P>& m, const Vec3Of<P>& a)
{
    return {m.row0.x * a.x + m.row1.x * a.y + m.row2.x * a.z,
            m.row0.y * a.x + m.row1.y * a.y + m.row2.y * a.z,
            m.row0.z * a.x + m.row1.z * a.y + m.row2.z * a.z};
}

// Four numbers; of a quaternion, w is the scalar part.
template <typename P>
struct Vec4Of {
    P w, x, y, z;

    EPODE_LANEWISE Vec3Of<P> first_three() const { return {w, x, y}; }
    EPODE_LANEWISE Vec3Of<P> vector_part() const { return {x, y, z}; }
};

template <typename P>
EPODE_LANEWISE Vec4Of<P> conjugate(const Vec4Of<P>& q)
{
    return {q.w, -q.x, -q.y, -q.z};
}

// The Hamilton product.
template <typename P>
EPODE_LANEWISE Vec4Of<P> operator*(const Vec4Of<P>& a, const Vec4Of<P>& b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

// a rotated by the unit quaternion q: a + w t + q x t, t = 2 q x a.
template <typename P>
EPODE_LANEWISE Vec3Of<P> rotated(const Vec4Of<P>& q, const Vec3Of<P>& a)
{
    const Vec3Of<P> u = cross(q.vector_part(), a), t = u + u;
    return a + q.w * t + cross(q.vector_part(), t);
}

}  // namespace
}  // namespace epode
