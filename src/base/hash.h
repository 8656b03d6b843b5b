// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A hash of two serial numbers, for tables whose size is a power of two (multipliers and shifts as in
// SplitMix64).
#pragma once

#include <cstddef>
#include <cstdint>

namespace epode {

inline std::size_t hash_of(std::uint64_t a, std::uint64_t b)
{
    std::uint64_t z = a * 0x9e3779b97f4a7c15u + b * 0xc2b2ae3d27d4eb4fu;
    z ^= z >> 29;
    z *= 0xbf58476d1ce4e5b9u;
    return std::size_t(z ^ (z >> 32));
}

}  // namespace epode
