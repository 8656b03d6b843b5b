// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where drawstuff's camera stands and looks: place (x, y, z), heading, pitch, roll in degrees. Its axes are
// the columns of Rz(h) Ry(-p) Rx(r): forward, left, up. Angles rather than a matrix are the state, because
// programs set and read them, and because the mouse turns them one by one.
#pragma once

#include "viewer/picture.h"

namespace epode::drawstuff {

// Buttons held while the mouse moves.
constexpr int kLeftButton = 1, kMiddleButton = 2, kRightButton = 4;

struct Viewpoint {
    float xyz[3] = {2, 0, 1};
    float hpr[3] = {180, 0, 0};

    // Each may be null. Numbers that are not finite change nothing.
    void set(const float* place, const float* angles);

    // The mouse moved by dx to the right and dy down.
    void drag(int buttons, int dx, int dy);

    viewer::Camera camera(int width, int height) const;

  private:
    void wrap();
};

}  // namespace epode::drawstuff
