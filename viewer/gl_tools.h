// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Making OpenGL objects: programs, depth maps, the picture's canvas. Nothing is deleted here: the context of one picture owns it all
// (headless.h). Failures return zero or false with the driver's own words in `error`.
#pragma once

#include <epoxy/gl.h>

#include <string>

#include "shaders.h"

namespace epode::viewer {

// 0 on failure. Uniform block `Frame` is bound to point 0, the samplers sun_depth, sun_shadow, sky_shadow to units 0, 1, 2.
GLuint make_program(const ProgramText& text, std::string& error);

// A square depth texture, with `layers` > 0 an array of them. Outside it all is lit.
GLuint make_depth_map(GLenum target, GLenum format, int side, int layers);

// Comparing: linear-filtered shadow test. Otherwise: the depth itself, unfiltered.
GLuint make_depth_sampler(bool comparing);

// A framebuffer with colour (sRGB) and depth; samples 0: not multisampled.
GLuint make_canvas(int width, int height, int samples);

bool complete(const char* what, std::string& error);

}  // namespace epode::viewer
