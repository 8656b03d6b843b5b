// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// First-fit graph colouring of constraints between two bodies: constraints of one colour share no body. Each
// body has a mask of 64 used colours. A body that has used all of them (a platform under a thousand ropes)
// continues with a count of its own, one above the last colour of itself or its partner.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

#include "base/arena.h"

namespace epode {

// The colours of one body during colouring.
struct Palette {
    std::uint64_t used = 0;  // of the first 64 colours
    int beyond = 0;          // the first free colour above these
};

inline int first_free(Palette& a, Palette& b)
{
    constexpr int kMasked = 64;
    const std::uint64_t used = a.used | b.used;
    const int colour = std::countr_one(used);
    if (colour < kMasked) {
        a.used |= std::uint64_t(1) << colour;
        b.used |= std::uint64_t(1) << colour;
        return colour;
    }
    const int next = std::max(a.beyond, b.beyond);
    a.beyond = b.beyond = next + 1;
    return kMasked + next;
}

// Whether nothing of one colour shares a body. body(i, side): below 0 for what cannot move.
template <typename BodyOf>
bool disjoint(std::span<const int> colours, BodyOf&& body, Arena& arena)
{
    const Arena::Scope scope(arena);
    const auto keys = arena.take<std::uint64_t>(2 * int(colours.size()));
    if (arena.failed()) return true;
    std::size_t count = 0;
    for (std::size_t i = 0; i < colours.size(); ++i)
        for (int side = 0; side < 2; ++side)
            if (const int b = body(i, side); b >= 0)
                keys[count++] = std::uint64_t(colours[i]) << 32 | std::uint64_t(b);
    std::sort(keys.begin(), keys.begin() + std::ptrdiff_t(count));
    return std::adjacent_find(keys.begin(), keys.begin() + std::ptrdiff_t(count)) ==
           keys.begin() + std::ptrdiff_t(count);
}

}  // namespace epode
