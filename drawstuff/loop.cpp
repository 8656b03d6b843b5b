// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The loop's behaviour is drawstuff's: step is called in every frame, also when paused, for it draws as well;
// one step while paused is one frame that is not paused; only frames that simulate are captured.
#include "loop.h"

#include <algorithm>
#include <cstdio>

#include "messages.h"
#include "ppm.h"

namespace epode::drawstuff {

namespace {

constexpr float kSun[3] = {1, 0.4f, 1};
constexpr float kHaze = 0.008f;
constexpr float kShadowReach = 8;

Loop* running = nullptr;

}  // namespace

Loop* Loop::current() { return running; }

Loop::Loop(Surface& surface, viewer::Renderer* renderer, DrawList& list, const dsFunctions& functions,
           const Options& options)
    : surface_(surface),
      renderer_(renderer),
      list_(list),
      functions_(functions),
      textures_(options.textures),
      shadows_(options.shadows),
      paused_(options.paused),
      fine_(options.fine)
{
    running = this;
}

Loop::~Loop() { running = nullptr; }

void Loop::run()
{
    last_asked_ = surface_.seconds();
    if (functions_.start) functions_.start();
    std::vector<Event> events;
    while (!ended_ && surface_.next_frame(events)) {
        for (const Event& event : events) handle(event);
        events.clear();
        if (!ended_) frame();
    }
    if (functions_.stop) functions_.stop();
}

double Loop::elapsed()
{
    const double now = surface_.seconds(), passed = now - last_asked_;
    last_asked_ = now;
    return std::clamp(passed, 1e-16, 1.0);
}

void Loop::handle(const Event& event)
{
    switch (event.kind) {
        case Event::Kind::kKey:
            if (functions_.command) functions_.command(event.key);
            break;
        case Event::Kind::kControl:
            handle_control(event.key);
            break;
        case Event::Kind::kDrag:
            viewpoint_.drag(event.buttons, event.dx, event.dy);
            break;
    }
}

void Loop::handle_control(int letter)
{
    const float *xyz = viewpoint_.xyz, *hpr = viewpoint_.hpr;
    switch (letter) {
        case 'P':
            paused_ = !paused_;
            break;
        case 'O':
            step_once_ = paused_;
            break;
        case 'T':
            textures_ = !textures_;
            break;
        case 'S':
            shadows_ = !shadows_;
            break;
        case 'W':
            capturing_ = !capturing_;
            break;
        case 'X':
            ended_ = true;
            break;
        case 'V':
            std::printf("Viewpoint = (%.4f,%.4f,%.4f,%.4f,%.4f,%.4f)\n", static_cast<double>(xyz[0]),
                        static_cast<double>(xyz[1]), static_cast<double>(xyz[2]), static_cast<double>(hpr[0]),
                        static_cast<double>(hpr[1]), static_cast<double>(hpr[2]));
            std::fflush(stdout);
            break;
        default:
            break;
    }
}

void Loop::frame()
{
    const bool simulates = !paused_ || step_once_;
    step_once_ = false;
    list_.begin_frame();
    in_frame_ = true;
    if (functions_.step) functions_.step(simulates ? 0 : 1);
    in_frame_ = false;
    draw(simulates);
}

viewer::Picture Loop::picture() const
{
    viewer::Picture picture = list_.picture();
    picture.width = surface_.width();
    picture.height = surface_.height();
    picture.camera = viewpoint_.camera(picture.width, picture.height);
    std::copy(kSun, kSun + 3, picture.sun);
    picture.floor = textures_ ? viewer::Floor::kTextured : viewer::Floor::kPlain;
    picture.clouds = textures_;
    picture.shadows = shadows_;
    picture.haze = kHaze;
    picture.shadow_reach = kShadowReach;
    picture.hidden_lines = 0;
    // A line of 1.6 pixels in small pictures, growing with large ones.
    picture.line_width = std::max(2.0f, 1.6f * 720 / static_cast<float>(std::max(picture.height, 1)));
    picture.quality = fine_ ? viewer::kFine : viewer::kQuick;
    if (!textures_) {
        for (viewer::Shape& shape : picture.shapes) shape.texture = viewer::Texture::kNone;
        for (viewer::Triangle& triangle : picture.triangles) triangle.texture = viewer::Texture::kNone;
    }
    return picture;
}

void Loop::draw(bool simulated)
{
    const bool captures = capturing_ && simulated && surface_.width() > 0 && surface_.height() > 0;
    if (!renderer_ || (!surface_.is_seen() && !captures)) return;
    std::string error;
    const viewer::Picture picture = this->picture();
    if (!renderer_->draw(picture, error)) fail("%s", error.c_str());
    if (captures) capture(picture.width, picture.height);
    if (surface_.is_seen() && !surface_.show(*renderer_, error)) fail("%s", error.c_str());
}

void Loop::capture(int width, int height)
{
    viewer::Image image{width, height, {}};
    std::string error;
    if (!renderer_->read(image.rgb, error)) fail("%s", error.c_str());
    ++captured_;
    std::fprintf(stderr, "capturing frame %04d\n", captured_);
    char path[32];
    std::snprintf(path, sizeof path, "frame/frame%04d.ppm", captured_);
    if (!write_ppm(path, image)) fail("cannot write %s: is there a folder named frame?", path);
}

}  // namespace epode::drawstuff
