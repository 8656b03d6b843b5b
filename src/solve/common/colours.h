// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// First-fit colours for what connects two bodies, so that nothing of one colour shares a body: a mask of 64
// per body; a body that has used them all (a platform under a thousand ropes) goes on with a count of its
// own, one behind the last that it or its partner has.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace epode {

// What is known of a body while colours are given.
struct Palette {
    std::uint64_t used = 0;  // of the first 64 colours
    int beyond = 0;          // the first free one behind these
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

}  // namespace epode
