// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// EGL without surfaces (EGL_MESA_platform_surfaceless, EGL_KHR_surfaceless_context): Mesa's software
// rasteriser serves it on a machine with neither GPU nor X; where the platform is not offered, the default
// display is tried. The libraries are opened by libepoxy at first use and not linked, so that `epode` starts
// on a machine without OpenGL; epoxy ends the process when a library is absent, hence the look beforehand.
// The display itself stays initialised: EGL counts no users of it, so closing it could take it from another
// part of the program, and Mesa, unloaded on the way, leaves blocks behind that a leak checker can no longer
// name. GLX was rejected (needs X), OSMesa too (Mesa drops it).
#include "headless.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace epode::viewer {

namespace {

bool can_open(const char* library) { return dlopen(library, RTLD_LAZY | RTLD_LOCAL) != nullptr; }

bool has_client_extension(const char* name) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, name); }

EGLContext make_context(EGLDisplay display)
{
    const EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count < 1) return EGL_NO_CONTEXT;
    const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                         3,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         3,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
}

}  // namespace

bool Headless::open_display()
{
    EGLint major = 0, minor = 0;
    if (has_client_extension("EGL_EXT_platform_base") &&
        has_client_extension("EGL_MESA_platform_surfaceless")) {
        display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ && eglInitialize(display_, &major, &minor)) return true;
    }
    display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display_ && eglInitialize(display_, &major, &minor)) return true;
    display_ = nullptr;
    return false;
}

bool Headless::open(std::string& error)
{
    if (!can_open("libEGL.so.1") || !(can_open("libOpenGL.so.0") || can_open("libGL.so.1"))) {
        error =
            "no picture: libEGL.so.1 or libGL.so.1 is not installed (Debian: apt-get install libegl1 libgl1)";
        return false;
    }
    if (!open_display()) {
        error =
            "no picture: no EGL display can be opened (Debian: apt-get install libegl-mesa0 libgl1-mesa-dri)";
        return false;
    }
    if (!eglBindAPI(EGL_OPENGL_API) || (context_ = make_context(display_)) == EGL_NO_CONTEXT) {
        error = "no picture: the EGL display offers no OpenGL 3.3 core context";
        return false;
    }
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
        error = "no picture: the EGL display cannot draw without a surface";
        return false;
    }
    return true;
}

Headless::~Headless()
{
    if (!display_) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_) eglDestroyContext(display_, context_);
}

}  // namespace epode::viewer
