// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Computing with Lanes one vector of them at a time, and not two as in a Register: for what is chains enough
// by itself, as the rows of a joint or the components of a rotation are. As everything in simd/vectors.h,
// this is compiled once per kind of machine and leaves the bits of the scalar formulas.
#pragma once

#include "simd/vectors.h"

namespace epode {
namespace {

EPODE_LANEWISE Vector3 get3(const Lanes* x, int part)
{
    return {get(x[0], part), get(x[1], part), get(x[2], part)};
}

EPODE_LANEWISE Vector3 plus(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
EPODE_LANEWISE Vector3 minus(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
EPODE_LANEWISE Vector3 times(const Vector& s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }

EPODE_LANEWISE Vector inner(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

EPODE_LANEWISE Vector3 outer(const Vector3& a, const Vector3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// xx, yy, zz, xy, xz, yz times a.
EPODE_LANEWISE Vector3 tensor(const Lanes* s, int part, const Vector3& a)
{
    const Vector xy = get(s[3], part), xz = get(s[4], part), yz = get(s[5], part);
    return {get(s[0], part) * a.x + xy * a.y + xz * a.z, xy * a.x + get(s[1], part) * a.y + yz * a.z,
            xz * a.x + yz * a.y + get(s[2], part) * a.z};
}

EPODE_LANEWISE Vector positive_or(const Vector& test, const Vector& yes, const Vector& no)
{
    return test > Vector{} ? yes : no;
}

EPODE_LANEWISE Vector clip(const Vector& x, const Vector& lo, const Vector& hi)
{
    const Vector below = x > hi ? hi : x;
    return below < lo ? lo : below;
}

EPODE_LANEWISE Vector4 get4(const Lanes* q, int part)
{
    return {get(q[0], part), get(q[1], part), get(q[2], part), get(q[3], part)};
}

EPODE_LANEWISE void put3(Lanes* to, int part, const Vector3& a)
{
    put(to[0], part, a.x), put(to[1], part, a.y), put(to[2], part, a.z);
}

EPODE_LANEWISE Vector3 vec_of(const Vector4& q) { return {q.x, q.y, q.z}; }

EPODE_LANEWISE Vector4 conjugate_of(const Vector4& q) { return {q.w, -q.x, -q.y, -q.z}; }

// The Hamilton product, in the order of operations of math/pose.h.
EPODE_LANEWISE Vector4 product(const Vector4& a, const Vector4& b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

// a as the unit quaternion q turns it: a + w t + q x t, t = 2 q x a.
EPODE_LANEWISE Vector3 turned_by(const Vector4& q, const Vector3& a)
{
    const Vector3 u = outer(vec_of(q), a), t = plus(u, u);
    return plus(plus(a, times(q.w, t)), outer(vec_of(q), t));
}

}  // namespace
}  // namespace epode
