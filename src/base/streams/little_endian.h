// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers as states and files have them, little-endian, so that a file is the same whatever the machine. Where the processor is
// little-endian, too, these are copies and cost what std::memcpy() does; elsewhere the bytes of each number change places.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace epode {

static_assert(std::endian::native == std::endian::little || std::endian::native == std::endian::big);

// `count` numbers of `size` bytes each, from memory to a file or back; the two do not overlap.
template <std::size_t size>
inline void copy_little(void* to, const void* from, std::size_t count)
{
    if (count == 0) return;  // of nothing, addresses may be null
    if constexpr (std::endian::native == std::endian::little || size == 1) {
        std::memcpy(to, from, size * count);
    } else {
        const auto* in = static_cast<const std::byte*>(from);
        auto* out = static_cast<std::byte*>(to);
        for (std::size_t i = 0; i < count; ++i, in += size, out += size)
            std::reverse_copy(in, in + size, out);
    }
}

// The number whose bytes in memory are those of `value` in a file, and the other way round.
template <typename T>
inline T little(T value)
{
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    T other;
    copy_little<sizeof value>(&other, &value, 1);
    return other;
}

template <typename T>
inline T get_little(const void* from, std::size_t i = 0)
{
    T value;
    copy_little<sizeof value>(&value, static_cast<const std::byte*>(from) + sizeof value * i, 1);
    return value;
}

}  // namespace epode
