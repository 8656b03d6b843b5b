// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The few verbs in which the renderer speaks to OpenGL 3.3. Only calls of the core profile that every driver
// since 2010 has; direct state access (4.5) would read better but shuts out drivers for nothing.
#include "gl_tools.h"

#include "frame.h"

namespace epode::viewer {

namespace {

// The sizes that C++ and GLSL must agree on are written once, in the headers, and handed to GLSL here.
std::string opening(GLenum stage)
{
    const auto define = [](const char* name, int value) {
        return std::string("#define ") + name + " " + std::to_string(value) + "\n";
    };
    return "#version 330 core\n" + define("SKY_LIGHTS", kSkyLights) + define("SPIRAL", kSpiral) +
           define("SUN_MAP_SIDE", kSunMapSide) + define("SAMPLES", kSamples) +
           (stage == GL_FRAGMENT_SHADER ? "#define FRAGMENT\n" : "");
}

GLuint compile(GLenum stage, const char* name, const char* text, std::string& error)
{
    const std::string first = opening(stage);
    const char* const parts[] = {first.c_str(), kShaderHead, text};
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 3, parts, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done) return shader;
    char log[1024] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    error = std::string("no picture: shader ") + name + " does not compile: " + log;
    return 0;
}

void bind_inputs(GLuint program)
{
    const GLuint block = glGetUniformBlockIndex(program, "Frame");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, 0);
    glUseProgram(program);
    const char* const samplers[] = {"sun_depth", "sun_shadow", "sky_shadow", "places", "normals", "paints"};
    for (int unit = 0; unit < 6; ++unit) glUniform1i(glGetUniformLocation(program, samplers[unit]), unit);
}

}  // namespace

GLuint make_program(const ProgramText& text, std::string& error)
{
    const GLuint vertex = compile(GL_VERTEX_SHADER, text.name, text.vertex, error);
    const GLuint fragment = vertex ? compile(GL_FRAGMENT_SHADER, text.name, text.fragment, error) : 0;
    if (!fragment) return 0;
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) {
        char log[1024] = "";
        glGetProgramInfoLog(program, sizeof log, nullptr, log);
        error = std::string("no picture: program ") + text.name + " does not link: " + log;
        return 0;
    }
    bind_inputs(program);
    return program;
}

GLuint make_depth_map(GLenum target, GLenum format, int side, int layers)
{
    GLuint map = 0;
    glGenTextures(1, &map);
    glBindTexture(target, map);
    const auto internal = static_cast<GLint>(format);
    if (layers > 0) {
        glTexImage3D(target, 0, internal, side, side, layers, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    } else {
        glTexImage2D(target, 0, internal, side, side, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    }
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    return map;
}

GLuint make_depth_sampler(bool comparing)
{
    GLuint sampler = 0;
    glGenSamplers(1, &sampler);
    const GLint filter = comparing ? GL_LINEAR : GL_NEAREST;
    const float far[4] = {1, 1, 1, 1};
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, far);
    if (comparing) {
        glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
    return sampler;
}

namespace {

GLuint make_framebuffer()
{
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    return framebuffer;
}

void attach_buffer(GLenum place, GLenum format, int width, int height, int samples)
{
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
}

}  // namespace

GLuint make_canvas(int width, int height)
{
    const GLuint canvas = make_framebuffer();
    attach_buffer(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, width, height, 0);
    return canvas;
}

Surfaces make_surfaces(int width, int height)
{
    Surfaces surfaces;
    surfaces.framebuffer = make_framebuffer();
    const GLenum formats[3] = {GL_RGBA32F, GL_RGBA16F, GL_RGBA8};
    const GLenum places[3] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    glGenTextures(3, surfaces.textures);
    for (int i = 0; i < 3; ++i) {
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, surfaces.textures[i]);
        glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, kSamples, formats[i], width, height, GL_TRUE);
        glFramebufferTexture2D(GL_FRAMEBUFFER, places[i], GL_TEXTURE_2D_MULTISAMPLE, surfaces.textures[i], 0);
    }
    attach_buffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height, kSamples);
    glDrawBuffers(3, places);
    return surfaces;
}

bool complete(const char* what, std::string& error)
{
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    const GLenum fault = glGetError();
    if (status == GL_FRAMEBUFFER_COMPLETE && fault == GL_NO_ERROR) return true;
    error = std::string("no picture: OpenGL refuses ") + what + " (framebuffer status " +
            std::to_string(status) + ", error " + std::to_string(fault) + ")";
    return false;
}

}  // namespace epode::viewer
