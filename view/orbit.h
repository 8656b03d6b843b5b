// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A camera that turns about a point: azimuth and elevation in radians, distance in metres. Dragging turns,
// shifts in the picture's plane, or comes closer; the point under a pixel is a ray.
#pragma once

#include "view/stage.h"
#include "viewer/picture.h"

namespace epode::view {

struct Ray {
    Vec origin, direction;  // direction of unit length
};

class Orbit {
  public:
    void look(Vec eye, Vec target);
    void look_like(const viewer::Camera& camera) { look(vec(camera.eye), vec(camera.target)); }

    // By pixels of a picture `height` high.
    void turn(double dx, double dy);
    void pan(double dx, double dy, int height);
    void zoom(double notches);
    void shift(Vec by) { target_ = target_ + by; }
    void aim(Vec target) { target_ = target; }

    Vec eye() const;
    // What is looked at appears this many pixels to the right of the picture's middle.
    void set_offset(double pixels) { offset_ = pixels; }
    viewer::Camera camera(int height) const;
    Ray ray(double x, double y, int width, int height) const;
    // Unit vectors of the picture's plane, and towards what is looked at.
    void axes(Vec& right, Vec& up, Vec& forward) const;

  private:
    // The sideways way of eye and target that makes the offset.
    Vec aside(int height) const;
    Vec target_{0, 0, 0};
    double azimuth_ = -1, elevation_ = 0.3, distance_ = 10, offset_ = 0;
};

}  // namespace epode::view
