// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where frames go and where keys come from. The loop knows no more of windows than this; a window, a folder
// of files and the tests' own surface are the three there are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "options.h"
#include "viewer/renderer.h"

namespace epode::drawstuff {

struct Event {
    enum class Kind { kKey, kControl, kDrag };
    Kind kind;
    int key = 0;      // kKey: the character; kControl: the capital letter pressed with Ctrl
    int buttons = 0;  // kDrag: see viewpoint.h; moved by dx to the right and dy down, in pixels
    int dx = 0, dy = 0;
};

class Surface {
  public:
    virtual ~Surface() = default;

    // Makes an OpenGL context current; called once, first. False: error says why.
    virtual bool open(int width, int height, std::string& error) = 0;

    // Waits for the time of the next frame and appends what happened since. False: there is none, the loop
    // ends.
    virtual bool next_frame(std::vector<Event>& events) = 0;

    // Whether anybody will see this frame; if not, it need not be drawn. Its size in pixels.
    virtual bool is_seen() const = 0;
    virtual int width() const = 0;
    virtual int height() const = 0;

    // Shows what the renderer drew last.
    virtual bool show(viewer::Renderer& renderer, std::string& error) = 0;

    // Seconds since some beginning.
    virtual double seconds() const = 0;
};

std::unique_ptr<Surface> make_headless_surface(const Options& options);

// Null where the library was built without windows.
std::unique_ptr<Surface> make_window_surface();

}  // namespace epode::drawstuff
