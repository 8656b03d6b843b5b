// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// stb_image_write compiled here and nowhere else, as a header-only library with internal linkage and with
// warnings off (CMakeLists.txt). libpng was rejected: one function is needed, and it would be one more
// library to install.
#include "png.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace epode::viewer {

bool write_rgb(const char* path, int width, int height, const std::uint8_t* rgb)
{
    return stbi_write_png(path, width, height, 3, rgb, 3 * width) != 0;
}

}  // namespace epode::viewer
