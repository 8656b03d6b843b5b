// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "base/streams/checksum.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace epode {
namespace {

constexpr int kLanes = 8;
constexpr std::uint64_t kFactor = 0xd6e8feb86659fd93u;

std::uint64_t step(std::uint64_t sum, std::uint64_t word) { return std::rotl(sum ^ word, 29) * kFactor; }

}  // namespace

std::uint64_t checksum(const void* bytes, std::size_t count)
{
    const auto* at = static_cast<const unsigned char*>(bytes);
    std::uint64_t sums[kLanes], words[kLanes];
    for (int i = 0; i < kLanes; ++i) sums[i] = kFactor + std::uint64_t(i);
    const auto take = [&] {
        for (int i = 0; i < kLanes; ++i) sums[i] = step(sums[i], words[i]);
    };
    std::size_t left = count;
    for (; left >= sizeof words; left -= sizeof words, at += sizeof words) {
        std::memcpy(words, at, sizeof words);
        take();
    }
    std::fill_n(words, kLanes, 0);
    if (left > 0) std::memcpy(words, at, left);
    take();
    std::uint64_t sum = count;
    for (const std::uint64_t lane : sums) sum = step(sum, lane);
    return sum ^ sum >> 32;
}

}  // namespace epode
