// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A camera that turns about a point: azimuth and elevation in radians, distance in metres. Dragging turns,
// shifts in the picture's plane, or comes closer; the point under a pixel is a ray. A view is composed as a
// picture of kAspect; it appears whole, as large as possible and centred, in the part of the window that
// nothing covers, and the rest of the window shows what is around it.
#pragma once

#include <vector>

#include "view/session/stage.h"
#include "viewer/picture.h"

namespace epode::view {

struct Ray {
    Vec origin, direction;  // direction of unit length
};

// A window and the part of it that no panel covers, in pixels; left and top from the upper left corner.
struct WindowArea {
    int width = 1280, height = 800;
    double left = 0, top = 0, clear_width = 1280, clear_height = 800;
};

class Orbit {
  public:
    static constexpr double kAspect = 1.6;  // width over height of a composed view

    void set_area(const WindowArea& area);
    void look(Vec eye, Vec target);
    void look_like(const viewer::Camera& camera) { look(vec(camera.eye), vec(camera.target)); }

    // Moves the eye back until the composed view holds all but a fiftieth of the points: a cannon ball
    // may begin far away.
    void hold(const std::vector<Vec>& points);

    // By pixels of the window.
    void turn(double dx, double dy);
    void pan(double dx, double dy);
    void zoom(double notches);
    void shift(Vec by) { target_ = target_ + by; }
    void aim(Vec target) { target_ = target; }

    Vec eye() const;
    viewer::Camera camera() const;
    Ray ray(double x, double y) const;
    // Unit vectors of the picture's plane, and towards what is looked at.
    void axes(Vec& right, Vec& up, Vec& forward) const;

  private:
    // What a pixel covers at distance 1 from the eye.
    double pixel() const;
    Vec target_{0, 0, 0};
    double azimuth_ = -1, elevation_ = 0.3, distance_ = 10;
    WindowArea area_;
};

}  // namespace epode::view
