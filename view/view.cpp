// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The loop: input, time, panels, picture. Without a window only those frames are drawn that are saved.
#include "view/view.h"

#include <imgui.h>

#include <backends/imgui_impl_opengl3.h>

#include <cstdio>
#include <cstdlib>

#include "view/app.h"
#include "view/screen.h"
#include "view/script.h"

namespace epode::view {

namespace {

bool has_display()
{
    const char* x11 = secure_getenv("DISPLAY");
    const char* wayland = secure_getenv("WAYLAND_DISPLAY");
    return (x11 && *x11) || (wayland && *wayland);
}

int report(ViewResult result, const std::string& problem)
{
    std::fprintf(stderr, "epode view: %s\n", problem.c_str());
    return result;
}

// ImGui's context, around everything that uses it.
class Panels {
  public:
    Panels()
    {
        ImGui::CreateContext();
        ImGui::StyleColorsDark();
        ImGui::GetIO().IniFilename = nullptr;
        ImGuiStyle& style = ImGui::GetStyle();
        style.WindowRounding = 0;
        style.FrameRounding = 3;
        style.WindowBorderSize = 0;
    }
    ~Panels() { ImGui::DestroyContext(); }
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;
};

struct Show {
    App& app;
    Screen& screen;
    viewer::Renderer& renderer;
    Script& script;
    const ViewOptions& options;
    bool windowless;
    int frames = 0;
    std::string status;
};

void print_status(Show& show)
{
    std::string now = show.app.summary();
    if (!show.options.status || now == show.status) return;
    std::printf("%s\n", now.c_str());
    std::fflush(stdout);
    show.status = std::move(now);
}

bool is_last(const Show& show)
{
    if (show.options.frames > 0) return show.frames == show.options.frames;
    return show.windowless && show.script.ended();
}

bool draw(Show& show, const std::string& file, std::string& error)
{
    if (!show.renderer.draw(show.app.picture(), error)) return false;
    show.renderer.show(show.screen.framebuffer());
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return file.empty() || save_screen(show.screen, file, error);
}

// False: error says what went wrong.
bool run(Show& show, std::string& error)
{
    std::vector<KeyPress> keys;
    for (bool last = false; !last;) {
        keys.clear();
        if (!show.screen.begin_frame(keys)) return true;
        std::string file = show.windowless ? show.script.play(show.app) : std::string();
        for (const KeyPress& key : keys) {
            if (!ImGui::GetIO().WantTextInput) show.app.key(key.name, key.repeated);
        }
        ++show.frames;
        last = show.app.wants_quit() || is_last(show);
        const bool final_picture = last && !show.options.picture.empty();
        if (final_picture) show.app.set_fine(true);
        ImGui::NewFrame();
        show.app.frame(show.screen.seconds(), show.screen.width(), show.screen.height());
        ImGui::Render();
        print_status(show);
        if ((!show.windowless || !file.empty()) && !draw(show, file, error)) return false;
        if (final_picture && !draw(show, show.options.picture, error)) return false;
        show.screen.end_frame();
    }
    return true;
}

}  // namespace

int view(const ViewOptions& options)
{
    const bool windowless = options.headless || !has_display();
    if (windowless && options.frames == 0 && options.script.empty())
        return report(kWrongUse,
                      "there is no display; without one say --frames N --picture FILE, or --script FILE");
    std::string problem;
    Script script;
    if (!options.script.empty() && !script.load(options.script, problem)) return report(kWrongUse, problem);
    const scenes::Runtime runtime;
    App app(options, windowless);
    const Panels panels;
    if (!app.open(problem)) return report(kWrongUse, problem);
    const std::unique_ptr<Screen> screen = windowless ? make_offscreen() : make_window();
    viewer::Renderer renderer;
    if (!screen->open(options.width, options.height, "epode view: " + options.what, problem) ||
        !renderer.open(problem))
        return report(kTrouble, problem);
    Show show{app, *screen, renderer, script, options, windowless, 0, {}};
    return run(show, problem) ? kShown : report(kTrouble, problem);
}

}  // namespace epode::view
