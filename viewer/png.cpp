// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// stb_image_write compiled here and nowhere else, as a header-only library with internal linkage and with
// warnings off (CMakeLists.txt). Its own writer of files does not look whether the disk is full. libpng was rejected: one function is needed, and it would be one more
// library to install.
#include "png.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace epode::viewer {

bool write_rgb(const char* path, int width, int height, const std::uint8_t* rgb)
{
    int size = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> bytes(
        stbi_write_png_to_mem(rgb, 3 * width, width, height, 3, &size), &std::free);
    errno = bytes ? 0 : ENOMEM;
    if (!bytes) return false;
    std::FILE* const file = std::fopen(path, "wb");
    if (!file) return false;
    const bool written = std::fwrite(bytes.get(), 1, size_t(size), file) == size_t(size);
    const int why = errno;
    if (std::fclose(file) == 0 && written) return true;
    if (why) errno = why;
    return false;
}

}  // namespace epode::viewer
