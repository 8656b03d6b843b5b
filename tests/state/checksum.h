// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The checksum of states and files of worlds, written down once more: eight lanes of words of eight bytes,
// s' = rotate(s ^ w, 29) m.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace epode::states {

inline std::uint64_t checksum(const unsigned char* at, std::size_t count)
{
    constexpr std::uint64_t m = 0xd6e8feb86659fd93u;
    const auto next = [](std::uint64_t s, std::uint64_t w) { return ((s ^ w) << 29 | (s ^ w) >> 35) * m; };
    std::uint64_t sums[8];
    for (unsigned i = 0; i < 8; ++i) sums[i] = m + i;
    std::vector<unsigned char> padded(at, at + count);
    padded.resize(count / 64 * 64 + 64);
    for (std::size_t i = 0; i < padded.size(); i += 8) {
        std::uint64_t word;
        std::memcpy(&word, &padded[i], 8);
        sums[i / 8 % 8] = next(sums[i / 8 % 8], word);
    }
    std::uint64_t sum = count;
    for (const std::uint64_t lane : sums) sum = next(sum, lane);
    return sum ^ sum >> 32;
}

}  // namespace epode::states
