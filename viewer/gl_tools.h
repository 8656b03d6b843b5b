// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Making OpenGL objects: programs, depth maps, the picture's canvas. Nothing is deleted here: the context of
// one picture owns it all (headless.h). Failures return zero or false with the driver's own words in `error`.
#pragma once

#include <epoxy/gl.h>

#include <string>

#include "shaders.h"

namespace epode::viewer {

// 0 on failure. Uniform block `Frame` is bound to point 0, the samplers sun_depth, sun_shadow, sky_shadow,
// places, normals, paints to units 0 to 5.
GLuint make_program(const ProgramText& text, std::string& error);

// A square depth texture, with `layers` > 0 an array of them. Outside it all is lit.
GLuint make_depth_map(GLenum target, GLenum format, int side, int layers);

// Comparing: linear-filtered shadow test. Otherwise: the depth itself, unfiltered.
GLuint make_depth_sampler(bool comparing);

// A framebuffer of one sRGB colour.
GLuint make_canvas(int width, int height);

// Three colour textures with kSamples samples a pixel (place and kind, normal, paint), and depth: what is
// seen, before light.
constexpr int kSamples = 4;
struct Surfaces {
    GLuint framebuffer = 0;
    GLuint textures[3] = {0, 0, 0};
};
Surfaces make_surfaces(int width, int height);

bool complete(const char* what, std::string& error);

}  // namespace epode::viewer
