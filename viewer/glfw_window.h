// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A window of GLFW with the OpenGL context that a Renderer wants, and waiting for the next frame in the
// window system's own call, so that keys come at once. A header of its own, for the two that open windows
// (drawstuff/window_surface.cpp, view/window.cpp): the renderer does not need GLFW.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string>

namespace epode::viewer {

class GlfwWindow {
  public:
    GlfwWindow() = default;
    ~GlfwWindow()
    {
        if (window_) glfwDestroyWindow(window_);
        if (started_) glfwTerminate();
    }
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    // Its context is current then; `interval`: of the screen's pictures, for how many glfwSwapBuffers waits.
    bool open(int wide, int high, const char* title, int interval, std::string& error)
    {
        started_ = glfwInit() == GLFW_TRUE;
        if (!started_) return fail("no window system answers", error);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        window_ = glfwCreateWindow(wide, high, title, nullptr, nullptr);
        if (!window_) return fail("no window with OpenGL 3.3 can be opened", error);
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(interval);
        glfwGetFramebufferSize(window_, &width, &height);
        return true;
    }

    // Serves events until that time of glfwGetTime. False: the window was closed.
    bool wait_until(double time)
    {
        glfwPollEvents();
        for (double rest = time - glfwGetTime(); rest > 0; rest = time - glfwGetTime())
            glfwWaitEventsTimeout(rest);
        glfwGetFramebufferSize(window_, &width, &height);
        return !glfwWindowShouldClose(window_);
    }

    GLFWwindow* get() const { return window_; }
    int width = 0, height = 0;  // in pixels; 0 where it is iconified

  private:
    static bool fail(const char* what, std::string& error)
    {
        const char* reason = nullptr;
        glfwGetError(&reason);
        error = std::string(what) + (reason ? std::string(": ") + reason : std::string());
        return false;
    }

    GLFWwindow* window_ = nullptr;
    bool started_ = false;
};

}  // namespace epode::viewer
