// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Reads a PNG back for the tests: 3 bytes a pixel, rows from the top; empty when the file is not a PNG.
// Behind it is stb_image, compiled in its own file because it does not pass our warnings; a reader other than
// the viewer's own writer, so that both cannot err alike.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

Image read_png(const std::string& path);
