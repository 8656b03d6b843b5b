// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The few verbs in which the renderer speaks to OpenGL 3.3. Only calls of the core profile that every driver
// since 2010 has; direct state access (4.5) would read better but shuts out drivers for nothing.
#include "gl_tools.h"

#include <cstring>

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
           define("SAMPLES", kSamples) + (stage == GL_FRAGMENT_SHADER ? "#define FRAGMENT\n" : "");
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
    const char* const samplers[] = {"sun_depth", "sun_shadow", "sky_shadow", "places", "normals",
                                    "paints",    "textures",   "veil",       "canvas"};
    for (int unit = 0; unit < 9; ++unit) glUniform1i(glGetUniformLocation(program, samplers[unit]), unit);
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

namespace {

bool in_software()
{
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return renderer && (std::strstr(renderer, "llvmpipe") || std::strstr(renderer, "softpipe"));
}

}  // namespace

GLuint make_picture_array(const std::vector<Image>& images, int side)
{
    GLuint array = 0;
    glGenTextures(1, &array);
    glBindTexture(GL_TEXTURE_2D_ARRAY, array);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGB8, side, side, static_cast<GLsizei>(images.size()), 0, GL_RGB,
                 GL_UNSIGNED_BYTE, nullptr);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t i = 0; i < images.size(); ++i) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(i), side, side, 1, GL_RGB,
                        GL_UNSIGNED_BYTE, images[i].rgb.data());
    }
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    // Sharper far away, for nothing; but a rasteriser in software takes five times as long for the floor.
    if (!in_software() && epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
        glTexParameterf(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    return array;
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

void attach_samples(GLenum place, GLuint texture, GLenum format, int width, int height)
{
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, kSamples, format, width, height, GL_TRUE);
    glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
}

}  // namespace

void Canvas::make(int width, int height)
{
    framebuffer = make_framebuffer();
    glGenTextures(1, &color);
    glBindTexture(GL_TEXTURE_2D, color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
}

void Canvas::free()
{
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &color);
}

void Surfaces::make(int width, int height)
{
    framebuffer = make_framebuffer();
    const GLenum formats[3] = {GL_RGBA32F, GL_RGBA16F, GL_RGBA8};
    const GLenum places[3] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    glGenTextures(3, textures);
    for (int i = 0; i < 3; ++i) attach_samples(places[i], textures[i], formats[i], width, height);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, GL_DEPTH_COMPONENT32F, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    glDrawBuffers(3, places);
}

void Surfaces::make_veil(int width, int height)
{
    veil_framebuffer = make_framebuffer();
    glGenTextures(1, &veil);
    attach_samples(GL_COLOR_ATTACHMENT0, veil, GL_RGBA16F, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
}

void Surfaces::free()
{
    const GLuint framebuffers[2] = {framebuffer, veil_framebuffer};
    glDeleteFramebuffers(2, framebuffers);
    glDeleteTextures(3, textures);
    glDeleteTextures(1, &veil);
    glDeleteRenderbuffers(1, &depth);
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
