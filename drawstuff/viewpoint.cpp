// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// With h, p, r in radians: forward = (ch cp, sh cp, sp), left = (-sh, ch, 0) and up = forward x left before
// the roll, which turns up about forward towards the right: up' = cos r up - sin r left. The scene follows
// the mouse: dragging to the right turns the view to the left.
#include "viewpoint.h"

#include <algorithm>
#include <cmath>

namespace epode::drawstuff {

namespace {

constexpr float kDegree = 3.14159265f / 180;
constexpr float kDegreesPerPixel = 0.5f;
constexpr float kMetresPerPixel = 0.01f;
constexpr float kTangent = 0.8f;    // of half the opening along the longer side of the window
constexpr float kViewDistance = 5;  // the near plane is a fiftieth of it

bool finite(const float* v)
{
    return std::all_of(v, v + 3, [](float x) { return std::fabs(x) < 1e15f; });
}

}  // namespace

void Viewpoint::wrap()
{
    for (float& angle : hpr) angle = std::remainder(angle, 360.0f);
}

void Viewpoint::set(const float* place, const float* angles)
{
    if ((place && !finite(place)) || (angles && !finite(angles))) return;
    if (place) std::copy(place, place + 3, xyz);
    if (angles) std::copy(angles, angles + 3, hpr);
    wrap();
}

void Viewpoint::drag(int buttons, int dx, int dy)
{
    const auto across = static_cast<float>(dx), down = static_cast<float>(dy);
    if (buttons == 0) return;
    if (buttons == kLeftButton) {
        hpr[0] += kDegreesPerPixel * across;
        hpr[1] += kDegreesPerPixel * down;
        wrap();
        return;
    }
    const float s = std::sin(hpr[0] * kDegree), c = std::cos(hpr[0] * kDegree);
    const float left = kMetresPerPixel * across;
    const float forward = buttons == kRightButton ? kMetresPerPixel * down : 0;
    xyz[0] += c * forward - s * left;
    xyz[1] += s * forward + c * left;
    if (buttons != kRightButton) xyz[2] += kMetresPerPixel * down;
}

viewer::Camera Viewpoint::camera(int width, int height) const
{
    const float h = hpr[0] * kDegree, p = hpr[1] * kDegree, r = hpr[2] * kDegree;
    const float forward[3] = {std::cos(h) * std::cos(p), std::sin(h) * std::cos(p), std::sin(p)};
    const float left[3] = {-std::sin(h), std::cos(h), 0};
    const float up[3] = {-std::cos(h) * std::sin(p), -std::sin(h) * std::sin(p), std::cos(p)};
    viewer::Camera camera;
    for (int i = 0; i < 3; ++i) {
        camera.eye[i] = xyz[i];
        camera.target[i] = xyz[i] + kViewDistance * forward[i];
        camera.up[i] = std::cos(r) * up[i] - std::sin(r) * left[i];
    }
    const float aspect = static_cast<float>(height) / static_cast<float>(width);
    camera.fov = 2 * std::atan(kTangent * std::min(1.0f, aspect)) / kDegree;
    return camera;
}

}  // namespace epode::drawstuff
