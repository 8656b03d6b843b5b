// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Writing pixels as a PNG file; the only door to stb, whose header does not pass our warnings.
#pragma once

#include <cstdint>

namespace epode::viewer {

// rgb: 3 bytes a pixel, rows from the top. False when the file cannot be written: errno tells why.
bool write_rgb(const char* path, int width, int height, const std::uint8_t* rgb);

}  // namespace epode::viewer
