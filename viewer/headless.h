// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An OpenGL 3.3 core context with no window and no display server. It owns all that is made in it: buffers,
// textures and programs are not freed one by one, they go when the context goes. One object of this class
// lives for one picture.
#pragma once

#include <string>

namespace epode::viewer {

class Headless {
  public:
    Headless() = default;
    ~Headless();
    Headless(const Headless&) = delete;
    Headless& operator=(const Headless&) = delete;

    // Makes the context current in this thread. On failure `error` says what was missing.
    bool open(std::string& error);

  private:
    bool open_display();
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace epode::viewer
