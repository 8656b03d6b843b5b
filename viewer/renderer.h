// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Draws a picture with the OpenGL context that is current in this thread and reads it back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "picture.h"

namespace epode::viewer {

// rgb: width * height * 3 bytes, rows from the top. On failure false, and error says which stage failed.
bool render(const Picture& picture, std::vector<std::uint8_t>& rgb, std::string& error);

}  // namespace epode::viewer
