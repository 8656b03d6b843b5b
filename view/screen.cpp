// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Reading a framebuffer back: OpenGL's rows come from below.
#include "view/screen.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "viewer/png.h"

namespace epode::view {

bool save_screen(const Screen& screen, const std::string& path, std::string& error)
{
    const int width = screen.width(), height = screen.height();
    const size_t row = size_t(width) * 3;
    std::vector<std::uint8_t> rgb(row * size_t(height));
    glBindFramebuffer(GL_FRAMEBUFFER, screen.framebuffer());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    for (int low = 0, high = height - 1; low < high; ++low, --high)
        std::swap_ranges(&rgb[row * size_t(low)], &rgb[row * size_t(low)] + row, &rgb[row * size_t(high)]);
    if (viewer::write_rgb(path.c_str(), width, height, rgb.data())) return true;
    error = "cannot write " + path;
    return false;
}

}  // namespace epode::view
