// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Frames as PNG files, by an OpenGL context without a window. Time is that of the frames, 1/60 s each, not
// the clock's: a program that steps by dsElapsedTime gives the same pictures on every machine. Where no
// pictures are wanted, no context is opened: such a run needs no OpenGL.
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "surface.h"
#include "viewer/headless.h"
#include "viewer/png.h"

namespace epode::drawstuff {

namespace {

constexpr double kFrameTime = 1.0 / 60;

class HeadlessSurface : public Surface {
  public:
    explicit HeadlessSurface(const Options& options)
        : folder_(options.frame_folder), count_(options.frame_count), every_(options.frame_every)
    {}

    bool open(int width, int height, std::string& error) override
    {
        width_ = width;
        height_ = height;
        if (folder_.empty()) return true;
        std::error_code fault;
        std::filesystem::create_directories(folder_, fault);
        if (!fault) return context_.open(error);
        error = "the folder " + folder_ + " cannot be made: " + fault.message();
        return false;
    }

    bool next_frame(std::vector<Event>&) override
    {
        if (count_ > 0 && frame_ >= count_) return false;
        ++frame_;
        return true;
    }

    bool is_seen() const override { return !folder_.empty() && frame_ % every_ == 0; }
    int width() const override { return width_; }
    int height() const override { return height_; }
    double seconds() const override { return kFrameTime * frame_; }

    bool show(viewer::Renderer& renderer, std::string& error) override
    {
        std::vector<std::uint8_t> rgb;
        if (!renderer.read(rgb, error)) return false;
        char name[32];
        std::snprintf(name, sizeof name, "/frame%04d.png", frame_);
        const std::string path = folder_ + name;
        if (viewer::write_rgb(path.c_str(), width_, height_, rgb.data())) return true;
        error = "cannot write " + path + ": " + std::strerror(errno);
        return false;
    }

  private:
    std::string folder_;
    int count_, every_;
    int width_ = 0, height_ = 0, frame_ = 0;
    viewer::Headless context_;
};

}  // namespace

std::unique_ptr<Surface> make_headless_surface(const Options& options)
{
    return std::make_unique<HeadlessSurface>(options);
}

}  // namespace epode::drawstuff
