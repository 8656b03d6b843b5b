// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The programs of a picture: of shapes and of triangles their depth as a light sees them, their surfaces, and
// what they look like when they are translucent; surface of the ground, light (and sky), lines; laying the
// translucent over the rest, and showing the canvas in a window.
#pragma once

namespace epode::viewer {

struct ProgramText {
    const char* name;
    const char* vertex;
    const char* fragment;
};

extern const char* const kShaderHead;  // uniform block and shared functions, before each text below
                                       // (gl_tools.cpp adds version and sizes)
extern const ProgramText kDepthProgram, kShapeProgram, kVeilProgram, kTriangleDepthProgram, kTriangleProgram,
    kTriangleVeilProgram, kGroundProgram, kLightProgram, kLineProgram, kVeilOverProgram, kShowProgram;

}  // namespace epode::viewer
