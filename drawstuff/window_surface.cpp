// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A window by GLFW. At most 60 frames a second: the next frame is due 1/60 s after the last was, or now if
// that has passed already. GLFW rather than SDL or bare Xlib: small, and it speaks to X11, Wayland, Windows
// and macOS alike.
#include <algorithm>

#include "surface.h"
#include "viewer/glfw_window.h"
#include "viewpoint.h"

namespace epode::drawstuff {

namespace {

constexpr double kFrameTime = 1.0 / 60;

class WindowSurface : public Surface {
  public:
    bool open(int width, int height, std::string& error) override;
    bool next_frame(std::vector<Event>& events) override;
    bool is_seen() const override { return window_.width > 0 && window_.height > 0; }
    int width() const override { return std::min(window_.width, viewer::kMaxPictureSide); }
    int height() const override { return std::min(window_.height, viewer::kMaxPictureSide); }
    double seconds() const override { return glfwGetTime(); }

    bool show(viewer::Renderer& renderer, std::string&) override
    {
        renderer.show(0);
        glfwSwapBuffers(window_.get());
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

    viewer::GlfwWindow window_;
    int buttons_ = 0;
    double mouse_x_ = 0, mouse_y_ = 0, due_ = 0;
    std::vector<Event> events_;
};

bool WindowSurface::open(int width, int height, std::string& error)
{
    if (!window_.open(width, height, "Simulation", 0, error)) return false;
    listen();
    due_ = glfwGetTime();
    return true;
}

void WindowSurface::listen()
{
    GLFWwindow* const window = window_.get();
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_character);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_motion);
    glfwGetCursorPos(window, &mouse_x_, &mouse_y_);
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
    const bool is_open = window_.wait_until(due_);
    due_ = std::max(due_ + kFrameTime, glfwGetTime());
    events.insert(events.end(), events_.begin(), events_.end());
    events_.clear();
    return is_open;
}

}  // namespace

std::unique_ptr<Surface> make_window_surface() { return std::make_unique<WindowSurface>(); }

}  // namespace epode::drawstuff
