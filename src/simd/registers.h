// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Computing with Lanes in vectors of the machine that the including file is compiled for: 32 bytes with AVX2,
// otherwise the 16 that every machine we serve has (SSE2, NEON). A Register is two such vectors: a visit to a
// contact is one long chain in which every operation waits for the one before, so the units idle half of the
// time unless a second, independent chain runs in between. Where a Register takes fewer lanes than kLanes, a
// kernel runs kParts times, each time over the part of the lanes that fits. The order of operations does not
// change with the width, and nothing is fused, so neither do the bits.
//
// One text compiled for several machines must not be merged by the linker: everything here is in an unnamed
// namespace, and code for a better machine than the baseline calls no shared inline function at all.
#pragma once

#include "simd/lanes.h"
#include "simd/lanewise.h"

namespace epode {
namespace {

#if defined(__AVX2__) || defined(dIDESINGLE)
#define EPODE_VECTOR_LANES 4
#else
#define EPODE_VECTOR_LANES 2
#endif
constexpr int kVector = EPODE_VECTOR_LANES;
constexpr int kRegister = 2 * kVector;
constexpr int kParts = kLanes / kRegister;

typedef Real Vector __attribute__((vector_size(kVector * sizeof(Real))));
typedef Vector VectorInMemory __attribute__((may_alias));
typedef Real PairInMemory __attribute__((vector_size(2 * sizeof(Real)), may_alias));

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

// Of these, x is the answer when the first argument is not a number.
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

EPODE_LANEWISE PairInMemory& pair_at(Real* p) { return *reinterpret_cast<PairInMemory*>(p); }
EPODE_LANEWISE PairInMemory pair_at(const Real* p) { return *reinterpret_cast<const PairInMemory*>(p); }

struct Vector3 {
    Vector x, y, z;
};

struct Vector4 {
    Vector w, x, y, z;
};

#if EPODE_VECTOR_LANES == 4
EPODE_LANEWISE Vector join(const Real* a, const Real* b)
{
    return __builtin_shufflevector(pair_at(a), pair_at(b), 0, 1, 2, 3);
}
#endif

// Between four numbers w, x, y, z at the place of each lane, aligned as four, and one vector per component:
// small matrices are transposed instead of moving number by number.
EPODE_LANEWISE Vector4 read_quads(const Real* const* at)
{
#if EPODE_VECTOR_LANES == 4
    const Vector wx02 = join(at[0], at[2]), wx13 = join(at[1], at[3]);
    const Vector yz02 = join(at[0] + 2, at[2] + 2), yz13 = join(at[1] + 2, at[3] + 2);
    return {__builtin_shufflevector(wx02, wx13, 0, 4, 2, 6), __builtin_shufflevector(wx02, wx13, 1, 5, 3, 7),
            __builtin_shufflevector(yz02, yz13, 0, 4, 2, 6), __builtin_shufflevector(yz02, yz13, 1, 5, 3, 7)};
#else
    const PairInMemory wx0 = pair_at(at[0]), wx1 = pair_at(at[1]);
    const PairInMemory yz0 = pair_at(at[0] + 2), yz1 = pair_at(at[1] + 2);
    return {__builtin_shufflevector(wx0, wx1, 0, 2), __builtin_shufflevector(wx0, wx1, 1, 3),
            __builtin_shufflevector(yz0, yz1, 0, 2), __builtin_shufflevector(yz0, yz1, 1, 3)};
#endif
}

EPODE_LANEWISE void write_quads(const Vector4& a, Real* const* at)
{
#if EPODE_VECTOR_LANES == 4
    const Vector wx02 = __builtin_shufflevector(a.w, a.x, 0, 4, 2, 6);
    const Vector wx13 = __builtin_shufflevector(a.w, a.x, 1, 5, 3, 7);
    const Vector yz02 = __builtin_shufflevector(a.y, a.z, 0, 4, 2, 6);
    const Vector yz13 = __builtin_shufflevector(a.y, a.z, 1, 5, 3, 7);
    const auto out = [at](int lane) -> VectorInMemory& {
        return *reinterpret_cast<VectorInMemory*>(at[lane]);
    };
    out(0) = __builtin_shufflevector(wx02, yz02, 0, 1, 4, 5);
    out(1) = __builtin_shufflevector(wx13, yz13, 0, 1, 4, 5);
    out(2) = __builtin_shufflevector(wx02, yz02, 2, 3, 6, 7);
    out(3) = __builtin_shufflevector(wx13, yz13, 2, 3, 6, 7);
#else
    pair_at(at[0]) = __builtin_shufflevector(a.w, a.x, 0, 2);
    pair_at(at[1]) = __builtin_shufflevector(a.w, a.x, 1, 3);
    pair_at(at[0] + 2) = __builtin_shufflevector(a.y, a.z, 0, 2);
    pair_at(at[1] + 2) = __builtin_shufflevector(a.y, a.z, 1, 3);
#endif
}

// The same for x, y, z and an unused number, which becomes zero.
EPODE_LANEWISE Vector3 read_vectors(const Real* const* at)
{
    const Vector4 a = read_quads(at);
    return {a.w, a.x, a.y};
}

EPODE_LANEWISE void write_vectors(const Vector3& a, Real* const* at)
{
    write_quads({a.x, a.y, a.z, Vector{}}, at);
}

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

}  // namespace
}  // namespace epode
