// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pictures as binary PPM (P6, 8 bits a channel): what drawstuff's textures and captured frames are.
#pragma once

#include <string>

#include "viewer/textures.h"

namespace epode::drawstuff {

// False when there is no such file or it is not of that kind; at most 8192 pixels a side.
bool read_ppm(const std::string& path, viewer::Image& image);

bool write_ppm(const std::string& path, const viewer::Image& image);

}  // namespace epode::drawstuff
