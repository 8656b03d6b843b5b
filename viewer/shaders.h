// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The five programs of a picture: depth of shapes as a light sees them, surfaces of shapes, surface of the
// ground, light (and sky), lines.
#pragma once

namespace epode::viewer {

struct ProgramText {
    const char* name;
    const char* vertex;
    const char* fragment;
};

extern const char* const kShaderHead;  // uniform block and shared functions, before each text below
                                       // (gl_tools.cpp adds version and sizes)
extern const ProgramText kDepthProgram, kShapeProgram, kGroundProgram, kLightProgram, kLineProgram;

}  // namespace epode::viewer
