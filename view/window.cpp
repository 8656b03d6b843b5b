// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A window by GLFW; Dear ImGui's own backend takes mouse and text, this file the keys, by what they write
// rather than by their place, whatever the keyboard's layout.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cctype>

#include "view/screen.h"
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
        if (window_) glfwDestroyWindow(window_);
        if (started_) glfwTerminate();
    }

    bool open(int width, int height, const std::string& title, std::string& error) override;
    bool begin_frame(std::vector<KeyPress>& keys) override;
    int width() const override { return std::clamp(width_, 1, viewer::kMaxPictureSide); }
    int height() const override { return std::clamp(height_, 1, viewer::kMaxPictureSide); }
    double seconds() const override { return seconds_; }
    unsigned framebuffer() const override { return 0; }
    void end_frame() override { glfwSwapBuffers(window_); }

  private:
    static Window& self(GLFWwindow* window)
    {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
    }
    static void on_key(GLFWwindow* window, int key, int, int action, int modifiers);
    static void on_character(GLFWwindow* window, unsigned character);

    GLFWwindow* window_ = nullptr;
    bool started_ = false, listening_ = false, drawing_ = false;
    int width_ = 0, height_ = 0;
    double last_ = 0, seconds_ = 0;
    bool held_ = false;  // the character that comes next is of a key that is held
    std::vector<KeyPress> keys_;
};

std::string glfw_message(const char* what)
{
    const char* reason = nullptr;
    glfwGetError(&reason);
    return std::string(what) + (reason ? std::string(": ") + reason : std::string());
}

bool Window::open(int width, int height, const std::string& title, std::string& error)
{
    started_ = glfwInit() == GLFW_TRUE;
    if (!started_) {
        error = glfw_message("no window system answers");
        return false;
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_) {
        error = glfw_message("no window with OpenGL 3.3 can be opened");
        return false;
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwGetFramebufferSize(window_, &width_, &height_);
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, on_key);
    glfwSetCharCallback(window_, on_character);
    listening_ = ImGui_ImplGlfw_InitForOpenGL(window_, true);
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
    glfwPollEvents();
    for (double rest = last_ + 1.0 / 120 - glfwGetTime(); rest > 0; rest = last_ + 1.0 / 120 - glfwGetTime())
        glfwWaitEventsTimeout(rest);
    const double now = glfwGetTime();
    seconds_ = std::min(now - last_, 0.25);
    last_ = now;
    keys.insert(keys.end(), keys_.begin(), keys_.end());
    keys_.clear();
    glfwGetFramebufferSize(window_, &width_, &height_);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    return !glfwWindowShouldClose(window_);
}

}  // namespace

std::unique_ptr<Screen> make_window() { return std::make_unique<Window>(); }

}  // namespace epode::view
