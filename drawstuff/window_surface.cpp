// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A window by GLFW. At most 60 frames a second: the next frame is due 1/60 s after the last was, or now if
// that has passed already; waiting is done in the window system's own call, so that keys come at once. GLFW
// rather than SDL or bare Xlib: small, and it speaks to X11, Wayland, Windows and macOS alike.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "surface.h"
#include "viewpoint.h"

namespace epode::drawstuff {

namespace {

constexpr double kFrameTime = 1.0 / 60;

class WindowSurface : public Surface {
  public:
    ~WindowSurface() override
    {
        if (window_) glfwDestroyWindow(window_);
        if (started_) glfwTerminate();
    }

    bool open(int width, int height, std::string& error) override;
    bool next_frame(std::vector<Event>& events) override;
    bool is_seen() const override { return width_ > 0 && height_ > 0; }
    int width() const override { return std::min(width_, viewer::kMaxPictureSide); }
    int height() const override { return std::min(height_, viewer::kMaxPictureSide); }
    double seconds() const override { return glfwGetTime(); }

    bool show(viewer::Renderer& renderer, std::string&) override
    {
        renderer.show(0);
        glfwSwapBuffers(window_);
        return true;
    }

  private:
    static WindowSurface& self(GLFWwindow* window)
    {
        return *static_cast<WindowSurface*>(glfwGetWindowUserPointer(window));
    }
    static void on_key(GLFWwindow* window, int key, int, int action, int modifiers);
    static void on_character(GLFWwindow* window, unsigned character);
    static void on_button(GLFWwindow* window, int button, int action, int);
    static void on_motion(GLFWwindow* window, double x, double y);
    void listen();

    GLFWwindow* window_ = nullptr;
    bool started_ = false;
    int width_ = 0, height_ = 0;
    int buttons_ = 0;
    double mouse_x_ = 0, mouse_y_ = 0, due_ = 0;
    std::vector<Event> events_;
};

std::string glfw_message(const char* what)
{
    const char* reason = nullptr;
    glfwGetError(&reason);
    return std::string(what) + (reason ? std::string(": ") + reason : std::string());
}

bool WindowSurface::open(int width, int height, std::string& error)
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
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    window_ = glfwCreateWindow(width, height, "Simulation", nullptr, nullptr);
    if (!window_) {
        error = glfw_message("no window with OpenGL 3.3 can be opened");
        return false;
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(0);
    glfwGetFramebufferSize(window_, &width_, &height_);
    listen();
    due_ = glfwGetTime();
    return true;
}

void WindowSurface::listen()
{
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, on_key);
    glfwSetCharCallback(window_, on_character);
    glfwSetMouseButtonCallback(window_, on_button);
    glfwSetCursorPosCallback(window_, on_motion);
    glfwGetCursorPos(window_, &mouse_x_, &mouse_y_);
}

void WindowSurface::on_key(GLFWwindow* window, int key, int, int action, int modifiers)
{
    if (action != GLFW_PRESS || !(modifiers & GLFW_MOD_CONTROL)) return;
    // By the letter on the key rather than by its place, whatever the keyboard's layout.
    const char* name = glfwGetKeyName(key, 0);
    const int letter = name && name[0] && !name[1] ? name[0] : key;
    self(window).events_.push_back(
        {Event::Kind::kControl, letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter});
}

void WindowSurface::on_character(GLFWwindow* window, unsigned character)
{
    const bool control = glfwGetKey(window, GLFW_KEY_LEFT_CONTROL) == GLFW_PRESS ||
                         glfwGetKey(window, GLFW_KEY_RIGHT_CONTROL) == GLFW_PRESS;
    if (!control && character >= 32 && character <= 126)
        self(window).events_.push_back({Event::Kind::kKey, static_cast<int>(character)});
}

void WindowSurface::on_button(GLFWwindow* window, int button, int action, int)
{
    const int bit = button == GLFW_MOUSE_BUTTON_LEFT     ? kLeftButton
                    : button == GLFW_MOUSE_BUTTON_MIDDLE ? kMiddleButton
                    : button == GLFW_MOUSE_BUTTON_RIGHT  ? kRightButton
                                                         : 0;
    int& buttons = self(window).buttons_;
    buttons = action == GLFW_PRESS ? buttons | bit : buttons & ~bit;
}

void WindowSurface::on_motion(GLFWwindow* window, double x, double y)
{
    WindowSurface& surface = self(window);
    const int dx = static_cast<int>(x - surface.mouse_x_), dy = static_cast<int>(y - surface.mouse_y_);
    surface.mouse_x_ += dx;
    surface.mouse_y_ += dy;
    if (surface.buttons_ != 0 && (dx != 0 || dy != 0))
        surface.events_.push_back({Event::Kind::kDrag, 0, surface.buttons_, dx, dy});
}

bool WindowSurface::next_frame(std::vector<Event>& events)
{
    glfwPollEvents();
    for (double rest = due_ - glfwGetTime(); rest > 0; rest = due_ - glfwGetTime())
        glfwWaitEventsTimeout(rest);
    due_ = std::max(due_ + kFrameTime, glfwGetTime());
    events.insert(events.end(), events_.begin(), events_.end());
    events_.clear();
    glfwGetFramebufferSize(window_, &width_, &height_);
    return !glfwWindowShouldClose(window_);
}

}  // namespace

std::unique_ptr<Surface> make_window_surface() { return std::make_unique<WindowSurface>(); }

}  // namespace epode::drawstuff
