// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all shaders know of one picture, laid out as their uniform block (std140: only vec4 and mat4, so C++
// and GLSL agree without padding), and the fitting of the lights. Light comes from the sun and from
// up to kSkyLights points spread evenly over the sky; each has a depth map, seen along its rays, in which a
// point looks up whether anything stands before it. The sky's many hard shadows add up to one soft one: the
// dark under a pile and between bricks. A single ambient term was tried on paper and rejected: it leaves
// everything in shadow flat.
#pragma once

#include "camera.h"

namespace epode::viewer {

// The most there may be of each; a picture's quality says how many there are.
constexpr int kSkyLights = 48;
constexpr int kSpiral = 48;
constexpr int kMinMapSide = 64, kMaxMapSide = 8192;

struct Frame {
    Mat4 camera;
    Mat4 sun;              // world to the sun's map, [0, 1]^3
    Mat4 sky[kSkyLights];  // world to layer i of the sky's map
    float sky_direction[kSkyLights][4];
    float eye[4];         // w: distance to the target
    float target[4];      // w: height of the ground
    float view_right[4];  // right, up, forward of the picture's plane at depth 1
    float view_up[4];
    float view_forward[4];
    float sun_right[4];        // the sun's axes; w: world size of its map
    float sun_up[4];           // w: depth range of its map
    float sun_direction[4];    // w: normal offset against self-shadow
    float options[4];          // grid spacing, sky's normal offset, sky lights, samples of the sun's map
    float viewport[4];         // width, height, half line width in pixels, width of the sun's map's pixel
    float look[4];             // haze, kind of floor, clouds, opacity of hidden lines
    float state[4];            // shadows, shift of the lens right and up, unused
    float spiral[kSpiral][4];  // points spread evenly over the unit disc: where a soft shadow is sampled
};

// The picture's quality within its bounds.
Quality bounded(const Quality& quality);

Frame make_frame(const Picture& picture);

}  // namespace epode::viewer
