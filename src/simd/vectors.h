// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vectors of the machine that the including file is compiled for: with AVX-512 one vector holds all eight
// lanes, with AVX2 it has 32 bytes, otherwise the 16 bytes that every supported machine has (SSE2, NEON). The
// order of operations does not depend on the width and nothing is fused, so the bits do not either.
//
// One text compiled for several machines must not be merged by the linker: everything here is in an unnamed
// namespace, and code for a better machine than the baseline calls no shared inline function at all.
#pragma once

#include "simd/components.h"
#include "simd/lanes.h"
#include "simd/lanewise.h"

namespace epode {
namespace {

#if !defined(EPODE_VECTOR_LANES)  // 8 in files that are compiled for AVX-512
#if defined(__AVX2__) || defined(dIDESINGLE)
#define EPODE_VECTOR_LANES 4
#else
#define EPODE_VECTOR_LANES 2
#endif
#endif
constexpr int kVector = EPODE_VECTOR_LANES;

typedef Real Vector __attribute__((vector_size(kVector * sizeof(Real))));
typedef Vector VectorInMemory __attribute__((may_alias));
typedef Real PairInMemory __attribute__((vector_size(2 * sizeof(Real)), may_alias));
// At any alignment.
typedef Real AnyPair __attribute__((vector_size(2 * sizeof(Real)), may_alias, aligned(sizeof(Real))));
typedef Real AnyRow __attribute__((vector_size(4 * sizeof(Real)), may_alias, aligned(sizeof(Real))));
typedef Real RowInMemory __attribute__((vector_size(4 * sizeof(Real)), may_alias));

// `part` counts vectors.
EPODE_LANEWISE Vector get(const Lanes& x, int part)
{
    return reinterpret_cast<const VectorInMemory*>(x.at)[part];
}

EPODE_LANEWISE void put(Lanes& x, int part, const Vector& value)
{
    reinterpret_cast<VectorInMemory*>(x.at)[part] = value;
}

// Square roots are correctly rounded everywhere; compilers make one instruction of this.
EPODE_LANEWISE Vector roots(const Vector& x)
{
    Vector out{};
    for (int lane = 0; lane < kVector; ++lane) out[lane] = Real(__builtin_sqrt(x[lane]));
    return out;
}

EPODE_LANEWISE PairInMemory& pair_at(Real* p) { return *reinterpret_cast<PairInMemory*>(p); }
EPODE_LANEWISE AnyPair pair_at(const Real* p) { return *reinterpret_cast<const AnyPair*>(p); }

using Vector3 = Vector3Of<Vector>;
using Vector4 = Vector4Of<Vector>;

#if EPODE_VECTOR_LANES == 4
EPODE_LANEWISE Vector join(const Real* a, const Real* b)
{
    return __builtin_shufflevector(pair_at(a), pair_at(b), 0, 1, 2, 3);
}
#elif EPODE_VECTOR_LANES == 8
EPODE_LANEWISE Vector join(const Real* a, const Real* b)
{
    return __builtin_shufflevector(*reinterpret_cast<const AnyRow*>(a), *reinterpret_cast<const AnyRow*>(b),
                                   0, 1, 2, 3, 4, 5, 6, 7);
}

EPODE_LANEWISE void split(const Vector& ab, Real* a, Real* b)
{
    *reinterpret_cast<RowInMemory*>(a) = __builtin_shufflevector(ab, ab, 0, 1, 2, 3);
    *reinterpret_cast<RowInMemory*>(b) = __builtin_shufflevector(ab, ab, 4, 5, 6, 7);
}

// Two matrices of four by four side by side.
EPODE_LANEWISE Vector4 transposed(const Vector4& m)
{
    const Vector wx02 = __builtin_shufflevector(m.w, m.x, 0, 8, 2, 10, 4, 12, 6, 14);
    const Vector wx13 = __builtin_shufflevector(m.w, m.x, 1, 9, 3, 11, 5, 13, 7, 15);
    const Vector yz02 = __builtin_shufflevector(m.y, m.z, 0, 8, 2, 10, 4, 12, 6, 14);
    const Vector yz13 = __builtin_shufflevector(m.y, m.z, 1, 9, 3, 11, 5, 13, 7, 15);
    return {__builtin_shufflevector(wx02, yz02, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(wx13, yz13, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(wx02, yz02, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(wx13, yz13, 2, 3, 10, 11, 6, 7, 14, 15)};
}
#endif

// Converts between four numbers w, x, y, z at the address of each lane (aligned as four where they are
// written) and one vector per component. Small matrices are transposed, instead of moving number by number.
EPODE_LANEWISE Vector4 read_quads(const Real* const* at)
{
#if EPODE_VECTOR_LANES == 4
    const Vector wx02 = join(at[0], at[2]), wx13 = join(at[1], at[3]);
    const Vector yz02 = join(at[0] + 2, at[2] + 2), yz13 = join(at[1] + 2, at[3] + 2);
    return {__builtin_shufflevector(wx02, wx13, 0, 4, 2, 6), __builtin_shufflevector(wx02, wx13, 1, 5, 3, 7),
            __builtin_shufflevector(yz02, yz13, 0, 4, 2, 6), __builtin_shufflevector(yz02, yz13, 1, 5, 3, 7)};
#elif EPODE_VECTOR_LANES == 8
    return transposed({join(at[0], at[4]), join(at[1], at[5]), join(at[2], at[6]), join(at[3], at[7])});
#else
    const AnyPair wx0 = pair_at(at[0]), wx1 = pair_at(at[1]);
    const AnyPair yz0 = pair_at(at[0] + 2), yz1 = pair_at(at[1] + 2);
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
#elif EPODE_VECTOR_LANES == 8
    const Vector4 quads = transposed(a);
    split(quads.w, at[0], at[4]), split(quads.x, at[1], at[5]);
    split(quads.y, at[2], at[6]), split(quads.z, at[3], at[7]);
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

}  // namespace
}  // namespace epode
