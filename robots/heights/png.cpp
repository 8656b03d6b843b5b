// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// PNG by stb_image, compiled here and nowhere else, with internal linkage, for PNG alone and with warnings off (CMakeLists.txt).
// The size that the file states is judged before, and no piece of memory is larger than kMaxPiece, so that small files do not
// become gigabytes. A build without libstb-dev says so.
#include "robots/heights/heights.h"

#ifdef EPODE_HAVE_STB

#include <cstdlib>

namespace {

// Four channels of two bytes and a byte of each row for as many samples as are read, and what stb reserves at a time.
constexpr std::size_t kMaxPiece = 10 * epode::robots::kMaxSamples;

void* limited_malloc(std::size_t size) { return size > kMaxPiece ? nullptr : std::malloc(size); }
void* limited_realloc(void* old, std::size_t size)
{
    return size > kMaxPiece ? nullptr : std::realloc(old, size);
}

}  // namespace

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MALLOC limited_malloc
#define STBI_REALLOC limited_realloc
#define STBI_FREE std::free
#include <stb/stb_image.h>

#endif

namespace epode::robots {

#ifdef EPODE_HAVE_STB

namespace {

// Big-endian.
double size_at(const std::string& bytes, size_t at)
{
    double value = 0;
    for (size_t i = 0; i < 4; ++i) value = 256 * value + double(static_cast<unsigned char>(bytes[at + i]));
    return value;
}

}  // namespace

bool read_png(const std::string& bytes, HeightField& field, std::string& problem)
{
    constexpr size_t kWidth = 16, kHeight = 20, kHead = 33;  // of the first chunk
    if (bytes.size() < kHead || bytes.compare(1, 3, "PNG") != 0) return problem = "is no PNG", false;
    if (!are_good_counts(size_at(bytes, kHeight), size_at(bytes, kWidth), problem)) return false;
    int width = 0, height = 0, channels = 0;
    stbi_uc* const pixels = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                                  int(bytes.size()), &width, &height, &channels, 0);
    if (!pixels) return problem = std::string("is a broken PNG: ") + stbi_failure_reason(), false;
    field.rows = height, field.columns = width;
    const size_t count = size_t(width) * size_t(height);
    field.samples.resize(count);
    for (size_t i = 0; i < count; ++i) field.samples[i] = double(pixels[i * size_t(channels)]);
    std::free(pixels);
    turn_over(field);
    return true;
}

#else

bool read_png(const std::string&, HeightField&, std::string& problem)
{
    problem = "is a PNG, which this build does not read: it was made without libstb-dev";
    return false;
}

#endif

}  // namespace epode::robots
