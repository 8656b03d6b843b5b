// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How a pair of geoms and its manifolds look in a state of the world:
//   n1, n2                  numbers of the geoms, 16 bits each; a word each where there are more
//   bits                    PairBit, then ManifoldBit of each manifold
//   separating axis         a word, if known
//   of each manifold        offset, turn, normal, anchors and separations when it was found, then what is not
//                           usual: couple against rolling, layer; present separations; impulses
// All numbers are floats as they lie in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "contacts/contact_pair.h"

namespace epode {

// Of a pair; the bits of its manifolds follow, kManifoldBits each.
enum PairBit : std::uint32_t { kManifolds = 3, kWanted = 4, kTouched = 8, kRests = 16, kSeparatingAxis = 32 };
enum ManifoldBit : std::uint32_t { kPoints = 7, kChanged = 8, kRoll = 16, kLayer = 32, kIdle = 64 };
inline constexpr int kFirstManifold = 8, kManifoldBits = 7;
static_assert(kFirstManifold + kSurfaceManifolds * kManifoldBits <= 32);

enum ListBit : std::uint32_t { kFewActive = 1, kUnfinished = 2, kSettled = 4 };
inline constexpr std::size_t kPairBytes = 8, kManifoldBytes = 80, kEventBytes = 12;  // at least
inline constexpr int kNarrowGeoms = 1 << 16;  // up to so many, the numbers of two geoms share a word

inline std::uint32_t bits_of_manifold(std::uint32_t pair_bits, int i)
{
    return pair_bits >> (kFirstManifold + i * kManifoldBits) & ((1u << kManifoldBits) - 1);
}

inline bool is_zero(Float3 v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// Where numbers go to, or come from, one after the other.
struct Writing {
    std::byte* at;
    template <int n>
    void operator()(const float* numbers)
    {
        std::memcpy(at, numbers, n * sizeof(float));
        at += n * sizeof(float);
    }
};
struct Reading {
    const std::byte* at;
    template <int n>
    void operator()(float* numbers)
    {
        std::memcpy(numbers, at, n * sizeof(float));
        at += n * sizeof(float);
    }
};

// All numbers of a manifold of so many points; of a constant number, since most of them are copied a few at
// once. Where no point has an impulse there are none.
template <int count, typename Kept, typename Move>
void move_points(Kept& kept, std::uint32_t bits, Move& move)
{
    static_assert(offsetof(ManifoldFinding, anchors) - offsetof(ManifoldFinding, offset) ==
                  15 * sizeof(float));
    static_assert(offsetof(ManifoldPoint, friction_impulse) - offsetof(ManifoldPoint, normal_impulse) ==
                  sizeof(float));
    auto& found = kept.found;
    auto& points = kept.manifold.points;
    move.template operator()<15>(&found.offset.x);
    for (int k = 0; k < 3; ++k)
        move.template operator()<count>(found.anchors.a1[k]),
            move.template operator()<count>(found.anchors.a2[k]);
    move.template operator()<count>(found.anchors.separation);
    if (bits & kRoll) move.template operator()<3>(&kept.manifold.rolling_impulse.x);
    if (bits & kLayer) move.template operator()<1>(&kept.layer);
    for (int i = 0; i < count; ++i) move.template operator()<1>(&points[i].separation);
    if (bits & kIdle) return;
    for (int i = 0; i < count; ++i) move.template operator()<4>(&points[i].normal_impulse);
}

template <typename Kept, typename Move>
void move_numbers(Kept& kept, std::uint32_t bits, Move& move)
{
    switch (bits & kPoints) {
        case 1:
            return move_points<1>(kept, bits, move);
        case 2:
            return move_points<2>(kept, bits, move);
        case 3:
            return move_points<3>(kept, bits, move);
        default:
            return move_points<4>(kept, bits, move);
    }
}

// Bytes of these.
inline std::size_t size_of_manifold(std::uint32_t bits)
{
    std::size_t numbers = 15 + (bits & kIdle ? 8 : 12) * std::size_t(bits & kPoints);
    if (bits & kRoll) numbers += 3;
    if (bits & kLayer) numbers += 1;
    return numbers * sizeof(float);
}

inline std::size_t size_of_pair(std::uint32_t bits, bool narrow)
{
    std::size_t size = narrow ? 8 : 12;
    if (bits & kSeparatingAxis) size += sizeof(std::uint32_t);
    for (int i = 0; i < int(bits & kManifolds); ++i) size += size_of_manifold(bits_of_manifold(bits, i));
    return size;
}

// To the last bit: -0 is something.
inline bool is_idle(const ContactManifold& manifold)
{
    std::uint32_t any = 0;
    for (int i = 0; i < manifold.count; ++i) {
        std::uint32_t bits[4];
        std::memcpy(bits, &manifold.points[i].normal_impulse, sizeof bits);
        any |= bits[0] | bits[1] | bits[2] | bits[3];
    }
    return any == 0;
}

inline std::uint32_t bits_of(std::uint32_t changes, float layer, const CachedManifold& kept)
{
    std::uint32_t bits = std::uint32_t(kept.manifold.count);
    if (kept.found.changes != changes) bits |= kChanged;
    if (!is_zero(kept.manifold.rolling_impulse)) bits |= kRoll;
    if (kept.layer != layer) bits |= kLayer;
    if (is_idle(kept.manifold)) bits |= kIdle;
    return bits;
}

}  // namespace epode
