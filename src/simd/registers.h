// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Arithmetic on Lanes, one Register at a time. A Register is two machine vectors (simd/vectors.h): a visit to
// a contact is one long dependency chain, and the execution units idle half of the time unless a second,
// independent chain runs in between. Where one vector holds all lanes there is no second one. Where a
// Register holds fewer lanes than kLanes, a kernel runs kParts times, each time over the lanes that fit. The
// bits do not depend on the width.
#pragma once

#include "simd/vectors.h"

namespace epode {
namespace {

constexpr int kRegister = kVector < kLanes ? 2 * kVector : kVector;
constexpr int kParts = kLanes / kRegister;

#if EPODE_VECTOR_LANES == 8
using Register = Vector;

EPODE_LANEWISE Register load(const Lanes& x, int part) { return get(x, part); }
EPODE_LANEWISE void store(Lanes& x, int part, const Register& value) { put(x, part, value); }
EPODE_LANEWISE Register all(Real x) { return Vector{} + x; }
EPODE_LANEWISE Register at_most(const Register& bound, const Register& x) { return bound < x ? bound : x; }
EPODE_LANEWISE Register at_least(const Register& bound, const Register& x) { return bound > x ? bound : x; }
EPODE_LANEWISE Register if_positive(const Register& test, const Register& yes, const Register& no)
{
    return test > Vector{} ? yes : no;
}
EPODE_LANEWISE Register square_root(const Register& x) { return roots(x); }
#else
struct Register {
    Vector a, b;
};

EPODE_LANEWISE Register load(const Lanes& x, int part)
{
    const VectorInMemory* from = reinterpret_cast<const VectorInMemory*>(x.at + part * kRegister);
    return {from[0], from[1]};
}

EPODE_LANEWISE void store(Lanes& x, int part, const Register& value)
{
    VectorInMemory* to = reinterpret_cast<VectorInMemory*>(x.at + part * kRegister);
    to[0] = value.a, to[1] = value.b;
}

EPODE_LANEWISE Register all(Real x) { return {Vector{} + x, Vector{} + x}; }
EPODE_LANEWISE Register operator+(const Register& x, const Register& y) { return {x.a + y.a, x.b + y.b}; }
EPODE_LANEWISE Register operator-(const Register& x, const Register& y) { return {x.a - y.a, x.b - y.b}; }
EPODE_LANEWISE Register operator*(const Register& x, const Register& y) { return {x.a * y.a, x.b * y.b}; }
EPODE_LANEWISE Register operator/(const Register& x, const Register& y) { return {x.a / y.a, x.b / y.b}; }
EPODE_LANEWISE Register operator-(const Register& x) { return {-x.a, -x.b}; }

// If the first argument is NaN, these return x.
EPODE_LANEWISE Register at_most(const Register& bound, const Register& x)
{
    return {bound.a < x.a ? bound.a : x.a, bound.b < x.b ? bound.b : x.b};
}

EPODE_LANEWISE Register at_least(const Register& bound, const Register& x)
{
    return {bound.a > x.a ? bound.a : x.a, bound.b > x.b ? bound.b : x.b};
}

// test > 0 ? yes : no
EPODE_LANEWISE Register if_positive(const Register& test, const Register& yes, const Register& no)
{
    const Vector zero{};
    return {test.a > zero ? yes.a : no.a, test.b > zero ? yes.b : no.b};
}

EPODE_LANEWISE Register square_root(const Register& x) { return {roots(x.a), roots(x.b)}; }
#endif

struct Register3 {
    Register x, y, z;
};

EPODE_LANEWISE Register3 load(const LaneVec3& a, int part)
{
    return {load(a.x, part), load(a.y, part), load(a.z, part)};
}

EPODE_LANEWISE Register3 operator+(const Register3& a, const Register3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

EPODE_LANEWISE Register3 operator-(const Register3& a, const Register3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

EPODE_LANEWISE Register3 operator*(const Register& s, const Register3& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

EPODE_LANEWISE Register dot(const Register3& a, const Register3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

EPODE_LANEWISE Register3 cross(const Register3& a, const Register3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct RegisterSym3 {
    Register xx, yy, zz, xy, xz, yz;
};

EPODE_LANEWISE RegisterSym3 load(const LaneSym3& s, int part)
{
    return {load(s.xx, part), load(s.yy, part), load(s.zz, part),
            load(s.xy, part), load(s.xz, part), load(s.yz, part)};
}

EPODE_LANEWISE Register3 operator*(const RegisterSym3& s, const Register3& a)
{
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}

#if EPODE_VECTOR_LANES == 8
EPODE_LANEWISE Register3 read_places(const Real* const* at)
{
    const Vector3 a = read_vectors(at);
    return {a.x, a.y, a.z};
}

EPODE_LANEWISE void write_places(const Register3& r, Real* const* at) { write_vectors({r.x, r.y, r.z}, at); }
#else
EPODE_LANEWISE Register3 read_places(const Real* const* at)
{
    const Vector3 a = read_vectors(at), b = read_vectors(at + kVector);
    return {{a.x, b.x}, {a.y, b.y}, {a.z, b.z}};
}

EPODE_LANEWISE void write_places(const Register3& r, Real* const* at)
{
    write_vectors({r.x.a, r.y.a, r.z.a}, at);
    write_vectors({r.x.b, r.y.b, r.z.b}, at + kVector);
}
#endif

}  // namespace
}  // namespace epode
