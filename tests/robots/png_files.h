// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// PNGs of grey pixels, with a stored (not compressed) stream. (PNG specification, second edition; RFC 1950 and 1951.)
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace epode::robots {

inline std::string big_endian(std::uint32_t value)
{
    return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

inline std::string png_chunk(const std::string& kind_and_data)
{
    std::uint32_t crc = ~0u;
    for (const char c : kind_and_data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return big_endian(std::uint32_t(kind_and_data.size() - 4)) + kind_and_data + big_endian(~crc);
}

// Row by row from the top.
inline std::string grey_png(std::uint32_t width, std::uint32_t height,
                            const std::vector<unsigned char>& pixels)
{
    std::string rows;
    for (std::uint32_t row = 0; row < height; ++row) {
        rows += '\0';  // not filtered
        rows.append(reinterpret_cast<const char*>(pixels.data()) + row * width, width);
    }
    std::uint32_t a = 1, b = 0;
    for (const char c : rows) a = (a + static_cast<unsigned char>(c)) % 65521, b = (b + a) % 65521;
    const std::uint32_t size = std::uint32_t(rows.size());
    std::string stream{'\x78', '\x01', '\x01', char(size), char(size >> 8), char(~size), char(~size >> 8)};
    stream += rows + big_endian(b << 16 | a);
    return std::string("\x89PNG\r\n\x1a\n", 8) +
           png_chunk("IHDR" + big_endian(width) + big_endian(height) + std::string("\x08\0\0\0\0", 5)) +
           png_chunk("IDAT" + stream) + png_chunk("IEND");
}

}  // namespace epode::robots
