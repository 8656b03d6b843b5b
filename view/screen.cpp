// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See screen.h.
#include "view/screen.h"

#include <cerrno>
#include <cstring>

#include "viewer/png.h"

namespace epode::view {

bool save_screen(const Screen& screen, const std::string& path, std::string& error)
{
    const int width = screen.width(), height = screen.height();
    const std::vector<std::uint8_t> rgb = viewer::read_pixels(screen.framebuffer(), width, height);
    if (viewer::write_rgb(path.c_str(), width, height, rgb.data())) return true;
    error = "cannot write " + path + ": " + std::strerror(errno);
    return false;
}

}  // namespace epode::view
