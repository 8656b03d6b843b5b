// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See hash.h for the definition.
#include "record/file/hash.h"

#include <bit>
#include <cstdio>

namespace epode::record {

namespace {

constexpr std::uint64_t kStart = 14695981039346656037ull;
constexpr std::uint64_t kPrime = 1099511628211ull;

template <size_t n>
std::uint64_t mixed(std::uint64_t hash, const std::array<double, n>& values)
{
    for (double value : values) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * kPrime;
        hash ^= hash >> 32;
    }
    return hash;
}

}  // namespace

std::uint64_t hash_states(const std::vector<BodyState>& bodies)
{
    std::uint64_t hash = kStart;
    for (const BodyState& body : bodies) {
        hash = mixed(hash, body.pose.pos);
        hash = mixed(hash, body.pose.turn);
        hash = mixed(hash, body.linear);
        hash = mixed(hash, body.angular);
    }
    return hash;
}

std::string as_text(std::uint64_t hash)
{
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

}  // namespace epode::record
