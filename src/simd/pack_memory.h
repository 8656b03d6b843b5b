// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Packs and memory. `load` and `store` are for lanes that are stored side by side, `gather` and `scatter` for
// objects somewhere in memory, one for each lane, of which they read or write four neighbouring numbers.
#pragma once

#include "simd/lanes.h"
#include "simd/pack.h"
#include "simd/pack_algebra.h"
#include "simd/transpose.h"

namespace epode {
namespace {

// Packs for a kind of lanes: one machine vector, for work that has enough independent chains of its own, such
// as the rows of a joint; or two, if there are lanes enough.
template <typename L, int vectors>
using PackOf = Pack<typename L::Number, (L::kCount < vectors * kVectorBytes / int(sizeof(typename L::Number))
                                             ? L::kCount
                                             : vectors * kVectorBytes / int(sizeof(typename L::Number)))>;
template <typename L>
using OneVector = PackOf<L, 1>;
template <typename L>
using TwoVectors = PackOf<L, 2>;

// Which of the packs P that hold the lanes of a batch: for (Part<P> part{}; part.first() < lanes; ++part).
template <typename P>
struct Part {
    int index;

    EPODE_LANEWISE constexpr int first() const { return index * P::kLanes; }  // lane
    EPODE_LANEWISE void operator++() { ++index; }
};

// Machine vectors at their place in an array of lanes.
template <typename P>
struct InLanes {
    typedef typename P::Vector Vector __attribute__((may_alias));
};

template <typename P, typename L>
EPODE_LANEWISE P load(const L& x, Part<P> part)
{
    const auto* from = reinterpret_cast<const typename InLanes<P>::Vector*>(x.at + part.first());
    P out;
    out.v[0] = from[0];
    if constexpr (P::kVectors > 1) out.v[1] = from[1];
    return out;
}

template <typename P, typename L>
EPODE_LANEWISE void store(L& x, Part<P> part, const P& value)
{
    auto* to = reinterpret_cast<typename InLanes<P>::Vector*>(x.at + part.first());
    to[0] = value.v[0];
    if constexpr (P::kVectors > 1) to[1] = value.v[1];
}

template <typename P, typename L>
EPODE_LANEWISE Vec3Of<P> load(const LaneVec3Of<L>& a, Part<P> part)
{
    return {load(a.x, part), load(a.y, part), load(a.z, part)};
}

template <typename P, typename L>
EPODE_LANEWISE void store(LaneVec3Of<L>& a, Part<P> part, const Vec3Of<P>& value)
{
    store(a.x, part, value.x), store(a.y, part, value.y), store(a.z, part, value.z);
}

template <typename P, typename L>
EPODE_LANEWISE Sym3Of<P> load(const LaneSym3Of<L>& s, Part<P> part)
{
    return {load(s.xx, part), load(s.yy, part), load(s.zz, part),
            load(s.xy, part), load(s.xz, part), load(s.yz, part)};
}

// The same of consecutive lanes.
template <typename P, typename L>
EPODE_LANEWISE Vec3Of<P> load3(const L* x, Part<P> part)
{
    return {load(x[0], part), load(x[1], part), load(x[2], part)};
}

template <typename P, typename L>
EPODE_LANEWISE Vec4Of<P> load4(const L* q, Part<P> part)
{
    return {load(q[0], part), load(q[1], part), load(q[2], part), load(q[3], part)};
}

template <typename P, typename L>
EPODE_LANEWISE Sym3Of<P> load_sym3(const L* s, Part<P> part)
{
    return {load(s[0], part), load(s[1], part), load(s[2], part),
            load(s[3], part), load(s[4], part), load(s[5], part)};
}

template <typename P, typename L>
EPODE_LANEWISE void store3(L* to, Part<P> part, const Vec3Of<P>& a)
{
    store(to[0], part, a.x), store(to[1], part, a.y), store(to[2], part, a.z);
}

template <typename P, typename L>
EPODE_LANEWISE void store4(L* to, Part<P> part, const Vec4Of<P>& q)
{
    store(to[0], part, q.w), store(to[1], part, q.x), store(to[2], part, q.y), store(to[3], part, q.z);
}

// row(lane): the four floats of every lane.
template <typename P, typename Row>
EPODE_LANEWISE Vec4Of<P> gather_rows(const Row& row)
{
    using V = typename P::Vector;
    Vec4Of<P> out;
    for (int i = 0; i < P::kVectors; ++i) {
        const auto of = [&](int lane) EPODE_INLINE_LAMBDA -> FloatRow { return row(i * P::kWidth + lane); };
        const auto columns = transposed_floats<V>(
            {float_rows<V>(of, 0), float_rows<V>(of, 1), float_rows<V>(of, 2), float_rows<V>(of, 3)});
        out.w.v[i] = columns.a, out.x.v[i] = columns.b, out.y.v[i] = columns.c, out.z.v[i] = columns.d;
    }
    return out;
}

// The four numbers at at(lane), a pointer, of every lane; for packs of floats also Reals, which are rounded.
template <typename P, typename At>
EPODE_LANEWISE Vec4Of<P> gather4(const At& at)
{
    if constexpr (sizeof(typename P::Number) == sizeof(float)) {
        return gather_rows<P>([&](int lane)
                                  EPODE_INLINE_LAMBDA -> FloatRow { return float_row_at(at(lane)); });
    } else {
        Vec4Of<P> out;
        for (int i = 0; i < P::kVectors; ++i) {
            const auto columns = double_columns<typename P::Vector>(
                [&](int lane) EPODE_INLINE_LAMBDA { return at(i * P::kWidth + lane); });
            out.w.v[i] = columns.a, out.x.v[i] = columns.b, out.y.v[i] = columns.c, out.z.v[i] = columns.d;
        }
        return out;
    }
}

// The four numbers N, `offset` bytes into the object of each lane.
template <typename P, typename N, typename T>
EPODE_LANEWISE Vec4Of<P> gather_members(const T* const* objects, std::size_t offset)
{
    return gather4<P>([=](int lane) EPODE_INLINE_LAMBDA {
        return reinterpret_cast<const N*>(reinterpret_cast<const char*>(objects[lane]) + offset);
    });
}

template <typename P, typename At>
EPODE_LANEWISE Vec3Of<P> gather3(const At& at)
{
    return gather4<P>(at).first_three();
}

// Writes the four numbers of each lane to at(lane).
template <typename P, typename At>
EPODE_LANEWISE void scatter4(const Vec4Of<P>& value, const At& at)
{
    using V = typename P::Vector;
    for (int i = 0; i < P::kVectors; ++i) {
        const auto of = [&](int lane) EPODE_INLINE_LAMBDA { return at(i * P::kWidth + lane); };
        const Columns<V> columns{value.w.v[i], value.x.v[i], value.y.v[i], value.z.v[i]};
        if constexpr (sizeof(typename P::Number) == sizeof(float))
            for_each_row(columns, [&](int lane, const FloatRow& row)
                                      EPODE_INLINE_LAMBDA { put_vector(of(lane), row); });
        else
            put_double_columns(columns, of);
    }
}

// The fourth number becomes zero.
template <typename P, typename At>
EPODE_LANEWISE void scatter3(const Vec3Of<P>& value, const At& at)
{
    scatter4<P>({value.x, value.y, value.z, P{}}, at);
}

// put(lane, FloatRow) for each lane of x, y, z and zero.
template <typename P, typename Put>
EPODE_LANEWISE void for_each_row(const Vec3Of<P>& value, const Put& put)
{
    using V = typename P::Vector;
    for (int i = 0; i < P::kVectors; ++i)
        for_each_row(Columns<V>{value.x.v[i], value.y.v[i], value.z.v[i], V{}},
                     [&](int lane, const FloatRow& row)
                         EPODE_INLINE_LAMBDA { put(i * P::kWidth + lane, row); });
}

}  // namespace
}  // namespace epode
