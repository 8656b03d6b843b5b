// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// write_png: refuse what cannot be drawn, open a context, render, write. Each step says its own failure; the
// file is opened last, so a picture that fails leaves no empty file behind.
#include "picture.h"

#include <cerrno>
#include <cstring>

#include "camera.h"
#include "headless.h"
#include "png.h"
#include "renderer.h"

namespace epode::viewer {

namespace {

bool side_is_valid(int side) { return side >= 1 && side <= kMaxPictureSide; }

}  // namespace

bool check_picture(const Picture& picture, std::string& error)
{
    if (!side_is_valid(picture.width) || !side_is_valid(picture.height)) {
        error = "no picture: width and height must lie between 1 and " + std::to_string(kMaxPictureSide);
    } else if (!valid(picture.camera)) {
        error =
            "no picture: the camera needs finite numbers, an eye apart from its target and an opening "
            "between 1 and 170 degrees";
    } else if (!finite(vec(picture.sun)) || !(std::fabs(picture.ground_height) < 1e15f)) {
        error = "no picture: the sun's direction or the ground's height is not finite";
    } else {
        return true;
    }
    return false;
}

bool write_png(const Picture& picture, const char* path, std::string& error)
{
    if (!path || !*path) {
        error = "no picture: no file name given";
        return false;
    }
    if (!check_picture(picture, error)) return false;
    Headless context;
    Renderer renderer;
    std::vector<std::uint8_t> rgb;
    if (!context.open(error) || !renderer.open(error) || !renderer.draw(picture, error) ||
        !renderer.read(rgb, error))
        return false;
    if (write_rgb(path, picture.width, picture.height, rgb.data())) return true;
    error = std::string("no picture: cannot write ") + path + ": " + std::strerror(errno);
    return false;
}

}  // namespace epode::viewer
