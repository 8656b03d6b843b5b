// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the renderer asks of camera.cpp beyond picture.h: the camera as a matrix, and the ball around a shape
// by which views and shadows are fitted. A ball rather than a box: it looks the same from all sides, so
// fitting needs one formula.
#pragma once

#include "matrix.h"
#include "picture.h"

namespace epode::viewer {

struct Ball {
    Vec center;
    float radius = 0;
};

Ball bounding_ball(const Shape& shape);

// The box that just holds a drawable shape, axes along the world's.
struct Bounds {
    Vec lo{1e30f, 1e30f, 1e30f};
    Vec hi{-1e30f, -1e30f, -1e30f};
    bool empty() const { return lo.x > hi.x; }
    void add(Vec p, float radius);
};

float view_distance(const Camera& camera);
Mat4 camera_matrix(const Camera& camera, float aspect);
bool valid(const Camera& camera);

}  // namespace epode::viewer
