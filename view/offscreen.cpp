// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A framebuffer in memory by a context without window or display. Time is that of the frames, 1/60 s each:
// the same input gives the same pictures.
#include <epoxy/gl.h>
#include <imgui.h>

#include <backends/imgui_impl_opengl3.h>

#include "view/screen.h"
#include "viewer/headless.h"

namespace epode::view {

namespace {

constexpr double kFrameTime = 1.0 / 60;

class Offscreen : public Screen {
  public:
    ~Offscreen() override
    {
        if (drawing_) ImGui_ImplOpenGL3_Shutdown();
    }

    bool open(int width, int height, const std::string&, std::string& error) override
    {
        width_ = width;
        height_ = height;
        if (!context_.open(error)) return false;
        glGenTextures(1, &color_);
        glBindTexture(GL_TEXTURE_2D, color_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            error = "no framebuffer of that size can be made";
            return false;
        }
        drawing_ = ImGui_ImplOpenGL3_Init("#version 330");
        if (!drawing_) error = "Dear ImGui does not find OpenGL";
        return drawing_;
    }

    bool begin_frame(std::vector<KeyPress>&) override
    {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {float(width_), float(height_)};
        io.DeltaTime = float(kFrameTime);
        ImGui_ImplOpenGL3_NewFrame();
        return true;
    }

    int width() const override { return width_; }
    int height() const override { return height_; }
    double seconds() const override { return kFrameTime; }
    unsigned framebuffer() const override { return framebuffer_; }
    void end_frame() override {}

  private:
    viewer::Headless context_;
    int width_ = 0, height_ = 0;
    GLuint framebuffer_ = 0, color_ = 0;
    bool drawing_ = false;
};

}  // namespace

std::unique_ptr<Screen> make_offscreen() { return std::make_unique<Offscreen>(); }

}  // namespace epode::view
