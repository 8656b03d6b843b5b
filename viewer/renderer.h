// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Draws one picture after the other with the OpenGL context that is current in this thread, a window's or one
// without: the renderer knows neither. It keeps programs, meshes, maps and canvases from picture to picture;
// they belong to the context and go with it, so a renderer is used with the context in which it was opened.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "picture.h"
#include "textures.h"

namespace epode::viewer {

// Pixels to lay over a picture: width * height * 3 bytes, rows from the top.
struct Panel {
    int width = 0, height = 0;
    const std::uint8_t* rgb = nullptr;
};

class Renderer {
  public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // False when the context cannot do what is needed; error says what.
    bool open(std::string& error);

    // Instead of our own texture; of any size. Before the first picture that uses it.
    void set_texture(Texture texture, const Image& image);

    // Into a canvas of its own. The picture must be one that write_png would take.
    bool draw(const Picture& picture, std::string& error);

    // The last picture: width * height * 3 bytes, rows from the top.
    bool read(std::vector<std::uint8_t>& rgb, std::string& error);

    // Copies the last picture into a framebuffer (0: the window's), to its bottom, `left` pixels from its left side.
    void show(unsigned framebuffer, int left = 0);

    // Lays an image over a framebuffer (0: the window's) that is `below` pixels high: its upper left corner goes x to the right and y
    // below the framebuffer's.
    static void lay(unsigned framebuffer, const Panel& panel, int x, int y, int below);

  private:
    struct Passes;
    std::unique_ptr<Passes> passes_;
};

// What is in a framebuffer (0: the window's): width * height * 3 bytes, rows from the top.
std::vector<std::uint8_t> read_pixels(unsigned framebuffer, int width, int height);

// Whether the picture's numbers can be drawn at all: size, camera, light; what in it cannot is left out by
// itself.
bool check_picture(const Picture& picture, std::string& error);

}  // namespace epode::viewer
