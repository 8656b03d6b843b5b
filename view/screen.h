// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where the viewer's frames go and where its input comes from: a window (window.cpp) or nothing but memory
// (offscreen.cpp). Input goes into Dear ImGui's own, but for keys, which have the names of actions.h.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viewer/renderer.h"

namespace epode::view {

struct KeyPress {
    std::string name;
    bool repeated = false;
};

class Screen {
  public:
    virtual ~Screen() = default;

    // Makes an OpenGL context current and tells ImGui of it; called once, first. False: error says why.
    virtual bool open(int width, int height, const std::string& title, std::string& error) = 0;
    // Waits for the next frame and begins it. False: the window was closed.
    virtual bool begin_frame(std::vector<KeyPress>& keys) = 0;
    virtual int width() const = 0;
    virtual int height() const = 0;
    // Since the last frame.
    virtual double seconds() const = 0;
    // Where to draw.
    virtual unsigned framebuffer() const = 0;
    virtual void end_frame() = 0;
};

std::unique_ptr<Screen> make_window();
std::unique_ptr<Screen> make_offscreen();

// What is in the screen's framebuffer, as a PNG file.
bool save_screen(const Screen& screen, const std::string& path, std::string& error);

}  // namespace epode::view
