// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// stb_image, compiled here and nowhere else, with internal linkage, for PNG alone and with warnings off
// (CMakeLists.txt).
#include "png_reader.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

Image read_png(const std::string& path)
{
    Image image;
    int channels = 0;
    unsigned char* pixels = stbi_load(path.c_str(), &image.width, &image.height, &channels, 3);
    if (!pixels) return image;
    image.rgb.assign(
        pixels, pixels + 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    stbi_image_free(pixels);
    return image;
}
