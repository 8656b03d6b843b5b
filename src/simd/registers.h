// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Computing with Lanes in registers of the machine that the including file is compiled for: 32 bytes with
// AVX2, otherwise the 16 that every machine we serve has (SSE2, NEON). Where a register takes fewer lanes
// than kLanes, a kernel runs kParts times, each time over the part of the lanes that fits. The order of
// operations does not change with the width, and nothing is fused, so neither do the bits.
//
// One text compiled for several machines must not be merged by the linker: everything here is in an unnamed
// namespace, and code for a better machine than the baseline calls no shared inline function at all.
#pragma once

#include "simd/lanes.h"

namespace epode {
namespace {

#if defined(__AVX2__) || defined(dIDESINGLE)
#define EPODE_REGISTER_LANES 4
#else
#define EPODE_REGISTER_LANES 2
#endif
constexpr int kRegister = EPODE_REGISTER_LANES;
constexpr int kParts = kLanes / kRegister;

typedef Real Register __attribute__((vector_size(kRegister * sizeof(Real))));
typedef Register RegisterInMemory __attribute__((may_alias));
typedef Real PairInMemory __attribute__((vector_size(2 * sizeof(Real)), may_alias));

[[gnu::always_inline]] inline Register load(const Lanes& a, int part)
{
    return *reinterpret_cast<const RegisterInMemory*>(a.at + part * kRegister);
}

[[gnu::always_inline]] inline void store(Lanes& a, int part, Register x)
{
    *reinterpret_cast<RegisterInMemory*>(a.at + part * kRegister) = x;
}

// The second argument wins when the first is not a number.
[[gnu::always_inline]] inline Register at_most(Register bound, Register x) { return bound < x ? bound : x; }
[[gnu::always_inline]] inline Register at_least(Register bound, Register x) { return bound > x ? bound : x; }

struct Register3 {
    Register x, y, z;
};

[[gnu::always_inline]] inline Register3 load(const LaneVec3& a, int part)
{
    return {load(a.x, part), load(a.y, part), load(a.z, part)};
}

[[gnu::always_inline]] inline Register3 operator+(const Register3& a, const Register3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

[[gnu::always_inline]] inline Register3 operator-(const Register3& a, const Register3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

[[gnu::always_inline]] inline Register3 operator*(const Register& s, const Register3& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

[[gnu::always_inline]] inline Register dot(const Register3& a, const Register3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[gnu::always_inline]] inline Register3 cross(const Register3& a, const Register3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct RegisterSym3 {
    Register xx, yy, zz, xy, xz, yz;
};

[[gnu::always_inline]] inline RegisterSym3 load(const LaneSym3& s, int part)
{
    return {load(s.xx, part), load(s.yy, part), load(s.zz, part),
            load(s.xy, part), load(s.xz, part), load(s.yz, part)};
}

[[gnu::always_inline]] inline Register3 operator*(const RegisterSym3& s, const Register3& a)
{
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}

[[gnu::always_inline]] inline PairInMemory& pair_at(Real* p) { return *reinterpret_cast<PairInMemory*>(p); }
[[gnu::always_inline]] inline PairInMemory pair_at(const Real* p)
{
    return *reinterpret_cast<const PairInMemory*>(p);
}

// Between four numbers x, y, z, unused at the place of each lane, aligned as four, and one register per
// component: small matrices are transposed instead of moving number by number.
#if EPODE_REGISTER_LANES == 4
[[gnu::always_inline]] inline Register join(const Real* a, const Real* b)
{
    return __builtin_shufflevector(pair_at(a), pair_at(b), 0, 1, 2, 3);
}

[[gnu::always_inline]] inline Register3 read_places(const Real* const* at)
{
    const Register xy02 = join(at[0], at[2]), xy13 = join(at[1], at[3]);
    const Register z02 = join(at[0] + 2, at[2] + 2), z13 = join(at[1] + 2, at[3] + 2);
    return {__builtin_shufflevector(xy02, xy13, 0, 4, 2, 6), __builtin_shufflevector(xy02, xy13, 1, 5, 3, 7),
            __builtin_shufflevector(z02, z13, 0, 4, 2, 6)};
}

[[gnu::always_inline]] inline void write_places(const Register3& a, Real* const* at)
{
    const Register zero{};
    const Register xy02 = __builtin_shufflevector(a.x, a.y, 0, 4, 2, 6);
    const Register xy13 = __builtin_shufflevector(a.x, a.y, 1, 5, 3, 7);
    const Register z02 = __builtin_shufflevector(a.z, zero, 0, 4, 2, 6);
    const Register z13 = __builtin_shufflevector(a.z, zero, 1, 5, 3, 7);
    const auto out = [at](int lane) -> RegisterInMemory& {
        return *reinterpret_cast<RegisterInMemory*>(at[lane]);
    };
    out(0) = __builtin_shufflevector(xy02, z02, 0, 1, 4, 5);
    out(1) = __builtin_shufflevector(xy13, z13, 0, 1, 4, 5);
    out(2) = __builtin_shufflevector(xy02, z02, 2, 3, 6, 7);
    out(3) = __builtin_shufflevector(xy13, z13, 2, 3, 6, 7);
}
#else
[[gnu::always_inline]] inline Register3 read_places(const Real* const* at)
{
    const PairInMemory xy0 = pair_at(at[0]), xy1 = pair_at(at[1]);
    const PairInMemory z0 = pair_at(at[0] + 2), z1 = pair_at(at[1] + 2);
    return {__builtin_shufflevector(xy0, xy1, 0, 2), __builtin_shufflevector(xy0, xy1, 1, 3),
            __builtin_shufflevector(z0, z1, 0, 2)};
}

[[gnu::always_inline]] inline void write_places(const Register3& a, Real* const* at)
{
    const Register zero{};
    pair_at(at[0]) = __builtin_shufflevector(a.x, a.y, 0, 2);
    pair_at(at[1]) = __builtin_shufflevector(a.x, a.y, 1, 3);
    pair_at(at[0] + 2) = __builtin_shufflevector(a.z, zero, 0, 2);
    pair_at(at[1] + 2) = __builtin_shufflevector(a.z, zero, 1, 3);
}
#endif

}  // namespace
}  // namespace epode
