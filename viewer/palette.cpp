// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The colours bodies get when nobody asks for others: earth and sea, of similar lightness so that none
// shouts, ordered so that neighbours in the row differ in hue. Fixed values rather than hues turned by the
// golden angle: those give candy, never a palette.
#include "picture.h"

namespace epode::viewer {

Color palette(int index)
{
    constexpr Color kColors[] = {
        {0.800f, 0.357f, 0.263f},  // terracotta
        {0.918f, 0.741f, 0.478f},  // sand
        {0.200f, 0.498f, 0.541f},  // deep teal
        {0.929f, 0.894f, 0.824f},  // cream
        {0.549f, 0.667f, 0.494f},  // sage
        {0.267f, 0.384f, 0.557f},  // denim
        {0.882f, 0.545f, 0.373f},  // apricot
        {0.537f, 0.412f, 0.510f},  // plum
    };
    constexpr int kCount = sizeof kColors / sizeof kColors[0];
    return kColors[(index % kCount + kCount) % kCount];
}

// The high bits of a product with an odd constant.
Color body_color(std::uint32_t number) { return palette(int((number * 2654435761u) >> 24)); }

}  // namespace epode::viewer
