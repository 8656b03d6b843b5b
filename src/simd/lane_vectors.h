// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Arithmetic on Lanes or FloatLanes, one machine vector of them at a time (a Register is two): for work that
// has enough independent chains of its own, such as the rows of a joint or the components of a rotation. Like
// everything in simd/vectors.h it is compiled once per kind of machine and gives the bits of the scalar
// formulas.
#pragma once

#include "simd/float_registers.h"
#include "simd/vectors.h"

namespace epode {
namespace {

// The machine vector for a kind of lanes; it holds `kWidth` of them.
template <typename L>
struct LaneVector;

template <>
struct LaneVector<Lanes> {
    using Type = Vector;
    static constexpr int kWidth = kVector;
};

template <>
struct LaneVector<FloatLanes> {
    using Type = FloatVector;
    static constexpr int kWidth = kFloatVector;
};

template <typename L>
using VectorOf = typename LaneVector<L>::Type;
template <typename L>
constexpr int kWidthOf = LaneVector<L>::kWidth;

// `part` counts vectors.
EPODE_LANEWISE FloatVector get(const FloatLanes& x, int part)
{
    return reinterpret_cast<const FloatVectorInMemory*>(x.at)[part];
}

EPODE_LANEWISE void put(FloatLanes& x, int part, const FloatVector& value)
{
    reinterpret_cast<FloatVectorInMemory*>(x.at)[part] = value;
}

template <typename L>
EPODE_LANEWISE Vector3Of<VectorOf<L>> get3(const L* x, int part)
{
    return {get(x[0], part), get(x[1], part), get(x[2], part)};
}

template <typename V>
EPODE_LANEWISE Vector3Of<V> plus(const Vector3Of<V>& a, const Vector3Of<V>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename V>
EPODE_LANEWISE Vector3Of<V> minus(const Vector3Of<V>& a, const Vector3Of<V>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename V>
EPODE_LANEWISE Vector3Of<V> times(const V& s, const Vector3Of<V>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

template <typename V>
EPODE_LANEWISE V dot(const Vector3Of<V>& a, const Vector3Of<V>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename V>
EPODE_LANEWISE Vector3Of<V> cross(const Vector3Of<V>& a, const Vector3Of<V>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The symmetric matrix xx, yy, zz, xy, xz, yz times a.
template <typename L>
EPODE_LANEWISE Vector3Of<VectorOf<L>> symmetric_times(const L* s, int part, const Vector3Of<VectorOf<L>>& a)
{
    const VectorOf<L> xy = get(s[3], part), xz = get(s[4], part), yz = get(s[5], part);
    return {get(s[0], part) * a.x + xy * a.y + xz * a.z, xy * a.x + get(s[1], part) * a.y + yz * a.z,
            xz * a.x + yz * a.y + get(s[2], part) * a.z};
}

template <typename V>
EPODE_LANEWISE V positive_or(const V& test, const V& yes, const V& no)
{
    return test > V{} ? yes : no;
}

template <typename V>
EPODE_LANEWISE V clip(const V& x, const V& lo, const V& hi)
{
    const V below = x > hi ? hi : x;
    return below < lo ? lo : below;
}

template <typename L>
EPODE_LANEWISE Vector4Of<VectorOf<L>> get4(const L* q, int part)
{
    return {get(q[0], part), get(q[1], part), get(q[2], part), get(q[3], part)};
}

template <typename L>
EPODE_LANEWISE void put3(L* to, int part, const Vector3Of<VectorOf<L>>& a)
{
    put(to[0], part, a.x), put(to[1], part, a.y), put(to[2], part, a.z);
}

template <typename L>
EPODE_LANEWISE void put4(L* to, int part, const Vector4Of<VectorOf<L>>& q)
{
    put(to[0], part, q.w), put(to[1], part, q.x), put(to[2], part, q.y), put(to[3], part, q.z);
}

template <typename V>
EPODE_LANEWISE bool any_positive(const V& a)
{
    bool any = false;
    for (int lane = 0; lane < int(sizeof(V) / sizeof(a[0])); ++lane) any |= a[lane] > 0;
    return any;
}

template <typename V>
EPODE_LANEWISE Vector3Of<V> vec_of(const Vector4Of<V>& q)
{
    return {q.x, q.y, q.z};
}

template <typename V>
EPODE_LANEWISE Vector4Of<V> conjugate_of(const Vector4Of<V>& q)
{
    return {q.w, -q.x, -q.y, -q.z};
}

// The Hamilton product, in the order of operations of math/pose.h.
template <typename V>
EPODE_LANEWISE Vector4Of<V> product(const Vector4Of<V>& a, const Vector4Of<V>& b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

// a rotated by the unit quaternion q: a + w t + q x t, t = 2 q x a.
template <typename V>
EPODE_LANEWISE Vector3Of<V> turned_by(const Vector4Of<V>& q, const Vector3Of<V>& a)
{
    const Vector3Of<V> u = cross(vec_of(q), a), t = plus(u, u);
    return plus(plus(a, times(q.w, t)), cross(vec_of(q), t));
}

typedef Real RealRow __attribute__((vector_size(4 * sizeof(Real))));

// Four neighbours in a structure that is aligned as one number. (Vector types with such an alignment lose it
// when they pass through references and templates.)
template <typename Row>
EPODE_LANEWISE void read_row(Row& to, const void* from, std::size_t offset)
{
    __builtin_memcpy(&to, static_cast<const char*>(from) + offset, sizeof to);
}

EPODE_LANEWISE FloatRow rounded(const RowInMemory& a) { return __builtin_convertvector(a, FloatRow); }

EPODE_LANEWISE FloatRow rounded_row(const void* from, std::size_t offset)
{
    RealRow row;
    read_row(row, from, offset);
    return __builtin_convertvector(row, FloatRow);
}

// Compilers make two conversions and a detour through memory of this, where one instruction is enough.
EPODE_LANEWISE void add_widened(const FloatRow& change, RowInMemory& to)
{
#if defined(__AVX2__) && !defined(dIDESINGLE)
    to = to + RealRow(_mm256_cvtps_pd(__m128(change)));
#else
    to = to + __builtin_convertvector(change, RealRow);
#endif
}

}  // namespace
}  // namespace epode
