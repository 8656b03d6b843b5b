// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How a pair of geoms and its manifolds look in a state of the world:
//   n1, n2            numbers of the geoms, 16 bits each; a word each where there are more
//   bits              PairBit, then ManifoldBit of each manifold, packed
//   separating axis   a word, if known
//   of each manifold  offset, turn, normal when it was found; then its points, side by side:
//                     a1    anchors in the frame of g1
//                     a2    anchors in the frame of g2: where a1 leads to, give or take some last places
//                     separation then, separation now
//                     couple against rolling, layer: where they are not usual
//                     impulses, unless no point has any
// Both anchors of a point are one place p of the world, seen by two geoms, so that up to rounding
//   a1 = R1' (p - p1),   a2 = R2' (p - p2) = turn' (a1 - offset),     turn = R1' R2, offset = R1' (p2 - p1)
// What is kept of a2 is how many floats lie between it and this formula, in 8 or 16 bits; where one of them is
// farther away, all as they are. All other numbers are floats as they lie in memory. No bit is lost.
// A manifold that is found no more takes as many bytes as before, so that differences between states are short.
// Format 3 had all of a2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "contacts/contact_pair.h"

namespace epode {

// Of a pair.
enum PairBit : std::uint32_t {
    kManifolds = 3,
    kWanted = 4,
    kTouched = 8,
    kRests = 16,
    kSeparatingAxis = 32,
    kStruck = 64,      // one of its manifolds is, or is at a border: a word with two bits for each follows
    kOtherStep = 128,  // it rests since a step of another size than the last: that size follows
};
// In that word: bit i of manifold i if it is struck, bit kSurfaceManifolds + i if it is at a border.
// Of a manifold.
enum ManifoldBit : std::uint32_t {
    kPoints = 7,
    kChanged = 8,
    kRoll = 16,
    kLayer = 32,
    kIdle = 64,     // no impulses
    kBytes = 128,   // a2 takes a byte for each number
    kShorts = 256,  // or two; else four
};
inline constexpr int kFirstManifold = 8, kManifoldBits = 8;
static_assert(kFirstManifold + kSurfaceManifolds * kManifoldBits <= 32);
// One to four points take two bits.
inline std::uint32_t packed(std::uint32_t bits) { return bits >> 3 << 2 | ((bits & kPoints) - 1); }
inline std::uint32_t unpacked(std::uint32_t byte) { return byte >> 2 << 3 | ((byte & 3) + 1); }

enum ListBit : std::uint32_t { kFewActive = 1, kUnfinished = 2, kSettled = 4 };
inline constexpr std::size_t kPairBytes = 8, kManifoldBytes = 80, kEventBytes = 12;  // at least
inline constexpr int kNarrowGeoms = 1 << 16;  // up to so many, the numbers of two geoms share a word

// Bytes of a pair with its manifolds, at most.
inline constexpr std::size_t kMaxManifoldBytes = sizeof(float) * (15 + 3 + 1 + 12 * kManifoldPoints);
inline constexpr std::size_t kMaxPairBytes =
    6 * sizeof(std::uint32_t) + kSurfaceManifolds * kMaxManifoldBytes;

// Writes the numbers of a manifold and returns its bits; kChanged is the caller's. `layer`: the usual one.
std::uint32_t write_manifold(const CachedManifold& kept, float layer, std::byte*& to);

// Bytes that a manifold of these bits has.
std::size_t size_of_manifold(std::uint32_t bits);
// Reads them; what the bits do not announce becomes as usual.
void read_manifold(const std::byte* from, std::uint32_t bits, float layer, CachedManifold& kept);

// The same of format 3, which has the first seven of these bits as they are.
inline constexpr int kManifoldBits3 = 7;
std::size_t size_of_manifold_3(std::uint32_t bits);
void read_manifold_3(const std::byte* from, std::uint32_t bits, float layer, CachedManifold& kept);

}  // namespace epode
