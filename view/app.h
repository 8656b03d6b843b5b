// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The viewer without its window: it receives keys, the mouse and the time by Dear ImGui's input, changes the
// session and its own switches, and lays out the panels. Whoever shows it (window.cpp, offscreen.cpp) draws
// picture() and then ImGui's draw data over it.
#pragma once

#include <memory>
#include <string>

#include "view/actions.h"
#include "view/drawing.h"
#include "view/orbit.h"
#include "view/session/live.h"
#include "view/view.h"

namespace epode::view {

class App {
  public:
    // Patient: frames wait for all steps that are due, however long they take, so that runs without a window
    // are the same on every machine.
    explicit App(const ViewOptions& options, bool patient = false) : options_(options), patient_(patient) {}

    // Opens options.what. False: problem says why; nothing is changed.
    bool open(std::string& problem) { return open(options_.what, problem); }
    bool open(const std::string& what, std::string& problem);

    void key(const std::string& name, bool repeated = false);
    void act(Action action);

    // Between ImGui::NewFrame and ImGui::Render; `seconds` since the last frame.
    void frame(double seconds, int width, int height);
    const viewer::Picture& picture() const { return picture_; }
    // One shown in the best light.
    void set_fine(bool fine) { fine_ = fine; }

    bool wants_quit() const { return quit_; }
    // What a test or a log may want to know: state, time, paused, picked.
    std::string summary() const;

  private:
    void look_at_everything();
    void look_from_scene();
    void follow_from_start(Live& live);
    void hold_what_moves();
    void follow();
    void use_mouse();
    void pick(double x, double y);
    void grab_or_pull(double x, double y);
    void push();
    void shoot();
    void other_scene(int by);
    // What an action switches on and off; null: it does something else.
    bool* switch_of(Action action);

    // panels.cpp
    // What the menus and, if they are shown, the panels leave free.
    WindowArea clear_area(int width, int height) const;
    void menus();
    void panels();
    void run_panel();
    void timeline();
    void solver_panel();
    void drawing_panel();
    void dials_panel();
    void body_panel();
    // diagnosis.cpp
    void diagnosis_panel();
    void pick_body(std::int32_t body);
    void note();
    // plots.cpp
    void plots_panel();
    // help.cpp
    void help();

    ViewOptions options_;
    bool patient_;
    std::string what_;
    std::unique_ptr<Session> session_;
    Drawing drawing_;
    Orbit orbit_;
    viewer::Picture picture_;
    std::int32_t picked_ = record::kNobody;
    std::uint32_t picked_geom_ = record::kNoGeom;
    Vec picked_local_;  // the picked point in the body's frame
    Vec followed_;
    double grab_depth_ = 0;
    double push_speed_ = 3;   // m/s that a push gives
    double shot_speed_ = 15;  // m/s
    bool following_ = false, panels_ = true, help_ = false, fine_ = false, quit_ = false;
    bool turning_ = false, panning_ = false;
    std::string note_;
    double note_until_ = 0, clock_ = 0;
};

}  // namespace epode::view
