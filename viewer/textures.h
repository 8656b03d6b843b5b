// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The textures of shapes, floor and sky, of our own making: computed when they are first wanted, in a few
// hundredths of a second, so there are no image files to install or to find. All can be laid side by side
// without a seam.
#pragma once

#include <cstdint>
#include <vector>

#include "picture.h"

namespace epode::viewer {

// 3 bytes of sRGB a pixel, rows from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

constexpr int kTextures = 4;
constexpr int kTextureSide = 512;

// kTextureSide squared. Of kNone: white.
Image make_texture(Texture texture);

// The same picture in kTextureSide squared: the mean of what falls into a pixel, or the nearest. Empty stays
// empty.
Image fitted(const Image& image);

}  // namespace epode::viewer
