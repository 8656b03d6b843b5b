// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "base/streams/checksum.h"

#include <bit>
#include <cstring>
#include <iterator>

#include "base/streams/little_endian.h"

namespace epode {
namespace {

constexpr int kLanes = 4;
// Odd, and half of their bits are set: splitmix64 of 1, 2 ...
constexpr std::uint64_t kKeys[kLanes] = {0x910a2dec89025cc1u, 0xbeeb8da1658eec67u, 0xf893a2eefb32555fu,
                                         0x71c18690ee42c90bu};

// Both halves of the product of 128 bits.
#if defined(__SIZEOF_INT128__)
__extension__ typedef unsigned __int128 Product;

std::uint64_t fold(std::uint64_t a, std::uint64_t b)
{
    const Product p = Product(a) * b;
    return std::uint64_t(p) ^ std::uint64_t(p >> 64);
}
#else
std::uint64_t fold(std::uint64_t a, std::uint64_t b)
{
    const auto low = [](std::uint64_t x) { return x & 0xffffffffu; };
    const std::uint64_t ll = low(a) * low(b), lh = low(a) * (b >> 32), hl = (a >> 32) * low(b);
    const std::uint64_t carry = (ll >> 32) + low(lh) + low(hl);
    const std::uint64_t high = (a >> 32) * (b >> 32) + (lh >> 32) + (hl >> 32) + (carry >> 32);
    return high ^ (carry << 32 | low(ll));
}
#endif

struct Sums {
    std::uint64_t of[kLanes] = {kKeys[0], kKeys[1], kKeys[2], kKeys[3]};

    void take(const unsigned char* at)
    {
        std::uint64_t words[2 * kLanes];
        copy_little<sizeof words[0]>(words, at, std::size(words));
        for (int i = 0; i < kLanes; ++i) of[i] = fold(words[2 * i] ^ of[i], words[2 * i + 1] ^ kKeys[i]);
    }
    std::uint64_t end(const unsigned char* at, std::size_t left, std::size_t count)
    {
        unsigned char last[kStripe] = {};
        if (left > 0) std::memcpy(last, at, left);
        take(last);
        std::uint64_t sum = count;
        for (int i = 0; i < kLanes; ++i) sum = fold(sum ^ of[i], kKeys[i]) + of[i];
        return sum;
    }
    static constexpr std::size_t kStripe = 16 * kLanes;
};

}  // namespace

std::uint64_t checksum(const void* bytes, std::size_t count)
{
    const auto* at = static_cast<const unsigned char*>(bytes);
    Sums sums;
    std::size_t left = count;
    for (; left >= Sums::kStripe; left -= Sums::kStripe, at += Sums::kStripe) sums.take(at);
    return sums.end(at, left, count);
}

std::uint64_t copy_and_sum(void* to, const void* bytes, std::size_t count)
{
    const auto* at = static_cast<const unsigned char*>(bytes);
    auto* copy = static_cast<unsigned char*>(to);
    Sums sums;
    std::size_t left = count;
    for (; left >= Sums::kStripe; left -= Sums::kStripe, at += Sums::kStripe, copy += Sums::kStripe) {
        sums.take(at);
        std::memcpy(copy, at, Sums::kStripe);
    }
    if (left > 0) std::memcpy(copy, at, left);
    return sums.end(at, left, count);
}

std::uint64_t checksum_3(const void* bytes, std::size_t count)
{
    constexpr int kOldLanes = 8;
    constexpr std::uint64_t kFactor = 0xd6e8feb86659fd93u;
    const auto step = [](std::uint64_t sum, std::uint64_t word) {
        return std::rotl(sum ^ word, 29) * kFactor;
    };
    const auto* at = static_cast<const unsigned char*>(bytes);
    std::uint64_t sums[kOldLanes], words[kOldLanes];
    for (int i = 0; i < kOldLanes; ++i) sums[i] = kFactor + std::uint64_t(i);
    const auto take = [&] {
        for (int i = 0; i < kOldLanes; ++i) sums[i] = step(sums[i], words[i]);
    };
    std::size_t left = count;
    for (; left >= sizeof words; left -= sizeof words, at += sizeof words) {
        copy_little<sizeof words[0]>(words, at, std::size(words));
        take();
    }
    unsigned char last[sizeof words] = {};
    if (left > 0) std::memcpy(last, at, left);
    copy_little<sizeof words[0]>(words, last, std::size(words));
    take();
    std::uint64_t sum = count;
    for (const std::uint64_t lane : sums) sum = step(sum, lane);
    return sum ^ sum >> 32;
}

}  // namespace epode
