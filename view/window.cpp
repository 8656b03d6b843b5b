// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A window by GLFW; Dear ImGui's own backend takes mouse and text, this file the keys, by what they write
// rather than by their place, whatever the keyboard's layout.
#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cctype>

#include "view/screen.h"
#include "viewer/glfw_window.h"
#include "viewer/picture.h"

namespace epode::view {

namespace {

struct NamedKey {
    int key;
    const char* name;
};

constexpr NamedKey kNamed[] = {
    {GLFW_KEY_RIGHT, "right"},
    {GLFW_KEY_LEFT, "left"},
    {GLFW_KEY_TAB, "tab"},
    {GLFW_KEY_F1, "f1"},
    {GLFW_KEY_BACKSPACE, "backspace"},
    {GLFW_KEY_ESCAPE, "escape"},
    {GLFW_KEY_HOME, "home"},
    {GLFW_KEY_END, "end"},
};

class Window : public Screen {
  public:
    ~Window() override
    {
        if (drawing_) ImGui_ImplOpenGL3_Shutdown();
        if (listening_) ImGui_ImplGlfw_Shutdown();
    }

    bool open(int width, int height, const std::string& title, std::string& error) override;
    bool begin_frame(std::vector<KeyPress>& keys) override;
    int width() const override { return std::clamp(window_.width, 1, viewer::kMaxPictureSide); }
    int height() const override { return std::clamp(window_.height, 1, viewer::kMaxPictureSide); }
    double seconds() const override { return seconds_; }
    unsigned framebuffer() const override { return 0; }
    void end_frame() override { glfwSwapBuffers(window_.get()); }

  private:
    static Window& self(GLFWwindow* window)
    {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
    }
    static void on_key(GLFWwindow* window, int key, int, int action, int modifiers);
    static void on_character(GLFWwindow* window, unsigned character);

    viewer::GlfwWindow window_;
    bool listening_ = false, drawing_ = false;
    double last_ = 0, seconds_ = 0;
    bool held_ = false;  // the character that comes next is of a key that is held
    std::vector<KeyPress> keys_;
};

bool Window::open(int width, int height, const std::string& title, std::string& error)
{
    if (!window_.open(width, height, title.c_str(), 1, error)) return false;
    glfwSetWindowUserPointer(window_.get(), this);
    glfwSetKeyCallback(window_.get(), on_key);
    glfwSetCharCallback(window_.get(), on_character);
    listening_ = ImGui_ImplGlfw_InitForOpenGL(window_.get(), true);
    drawing_ = listening_ && ImGui_ImplOpenGL3_Init("#version 330");
    if (!drawing_) error = "Dear ImGui does not find OpenGL";
    last_ = glfwGetTime();
    return drawing_;
}

void Window::on_key(GLFWwindow* window, int key, int, int action, int modifiers)
{
    if (action == GLFW_RELEASE) return;
    Window& w = self(window);
    w.held_ = action == GLFW_REPEAT;
    if (modifiers & GLFW_MOD_CONTROL) {
        const char* name = glfwGetKeyName(key, 0);
        if (name && name[0] && !name[1]) w.keys_.push_back({std::string("ctrl+") + name, w.held_});
        return;
    }
    for (const NamedKey& named : kNamed) {
        if (named.key == key) w.keys_.push_back({named.name, w.held_});
    }
}

void Window::on_character(GLFWwindow* window, unsigned character)
{
    Window& w = self(window);
    if (character == ' ')
        w.keys_.push_back({"space", w.held_});
    else if (character > 32 && character < 127)
        w.keys_.push_back({std::string(1, char(std::tolower(int(character)))), w.held_});
}

// Where the driver does not wait for the screen, frames come no oftener than 120 times a second.
bool Window::begin_frame(std::vector<KeyPress>& keys)
{
    const bool is_open = window_.wait_until(last_ + 1.0 / 120);
    const double now = glfwGetTime();
    seconds_ = std::min(now - last_, 0.25);
    last_ = now;
    keys.insert(keys.end(), keys_.begin(), keys_.end());
    keys_.clear();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    return is_open;
}

}  // namespace

std::unique_ptr<Screen> make_window() { return std::make_unique<Window>(); }

}  // namespace epode::view
