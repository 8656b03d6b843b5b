// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The checksum of states and files of worlds, written down once more: four lanes that take two words of eight
// bytes each in turn, s' = fold((w0 ^ s) (w1 ^ k)), where fold() adds the halves of a product without carry.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace epode::states {

// Halves by four products of 32 bits.
inline std::uint64_t fold(std::uint64_t a, std::uint64_t b)
{
    const std::uint64_t a0 = a & 0xffffffff, a1 = a >> 32, b0 = b & 0xffffffff, b1 = b >> 32;
    const std::uint64_t low = a0 * b0, middle = a1 * b0 + (low >> 32),
                        other = a0 * b1 + (middle & 0xffffffff);
    const std::uint64_t high = a1 * b1 + (middle >> 32) + (other >> 32);
    return (other << 32 | (low & 0xffffffff)) ^ high;
}

inline std::uint64_t checksum(const unsigned char* at, std::size_t count)
{
    constexpr std::uint64_t k[4] = {0x910a2dec89025cc1u, 0xbeeb8da1658eec67u, 0xf893a2eefb32555fu,
                                    0x71c18690ee42c90bu};
    std::uint64_t s[4] = {k[0], k[1], k[2], k[3]};
    std::vector<unsigned char> padded(at, at + count);
    padded.resize(count / 64 * 64 + 64);
    for (std::size_t i = 0; i < padded.size(); i += 16) {
        std::uint64_t w[2];
        std::memcpy(w, &padded[i], 16);
        const std::size_t lane = i / 16 % 4;
        s[lane] = fold(w[0] ^ s[lane], w[1] ^ k[lane]);
    }
    std::uint64_t sum = count;
    for (std::size_t i = 0; i < 4; ++i) sum = fold(sum ^ s[i], k[i]) + s[i];
    return sum;
}

}  // namespace epode::states
