// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One run of dsSimulationLoop: what the keys and the mouse do, when the program simulates, what a frame looks
// like, which frames are captured. It is given a surface and, if frames are to be drawn at all, a renderer.
#pragma once

#include "draw_list.h"
#include "options.h"
#include "surface.h"
#include "viewpoint.h"

namespace epode::drawstuff {

class Loop {
  public:
    Loop(Surface& surface, viewer::Renderer* renderer, DrawList& list, const dsFunctions& functions,
         const Options& options);
    ~Loop();
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

    // The loop that runs, or null.
    static Loop* current();

    // start, frames, stop.
    void run();

    void end() { ended_ = true; }
    bool in_frame() const { return in_frame_; }
    Viewpoint& viewpoint() { return viewpoint_; }
    double elapsed();

    // What was drawn since the frame began, with camera, light and floor.
    viewer::Picture picture() const;

  private:
    void handle(const Event& event);
    void handle_control(int letter);
    void frame();

    void draw(bool simulated);
    void capture(int width, int height);

    Surface& surface_;
    viewer::Renderer* renderer_;
    DrawList& list_;
    dsFunctions functions_;
    Viewpoint viewpoint_;
    bool textures_, shadows_, paused_, fine_;
    bool step_once_ = false, capturing_ = false, ended_ = false, in_frame_ = false;
    int captured_ = 0;
    double last_asked_ = 0;
};

}  // namespace epode::drawstuff
