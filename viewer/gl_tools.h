// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Making OpenGL objects: programs, depth maps, textures, and what is drawn into. What depends on the size of
// the picture can be freed, for windows change theirs; all else goes with the context. Failures return zero
// or false with the driver's own words in `error`.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <vector>

#include "shaders.h"
#include "textures.h"

namespace epode::viewer {

// 0 on failure. Uniform block `Frame` is bound to point 0, the samplers sun_depth, sun_shadow, sky_shadow,
// places, normals, paints, textures, veil, canvas to units 0 to 8.
GLuint make_program(const ProgramText& text, std::string& error);
constexpr GLuint kTexturesUnit = 6, kVeilUnit = 7, kCanvasUnit = 8;

// A square depth texture, with `layers` > 0 an array of them. Outside it all is lit.
GLuint make_depth_map(GLenum target, GLenum format, int side, int layers);

// Square pictures of one size as layers, repeated endlessly and smaller ones for what is far.
GLuint make_picture_array(const std::vector<Image>& images, int side);

// Comparing: linear-filtered shadow test. Otherwise: the depth itself, unfiltered.
GLuint make_depth_sampler(bool comparing);

// One sRGB colour a pixel: the finished picture.
struct Canvas {
    GLuint framebuffer = 0, color = 0;
    void make(int width, int height);
    void free();
};

// Three colour textures with kSamples samples a pixel (place and kind, normal, paint), and depth: what is
// seen, before light. The veil, made when it is first wanted, takes what is translucent: colour times
// opacity, and opacity, before the same depth.
constexpr int kSamples = 4;
struct Surfaces {
    GLuint framebuffer = 0, veil_framebuffer = 0;
    GLuint textures[3] = {0, 0, 0};
    GLuint veil = 0, depth = 0;
    void make(int width, int height);
    void make_veil(int width, int height);
    void free();
};

bool complete(const char* what, std::string& error);

}  // namespace epode::viewer
