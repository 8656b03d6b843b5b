// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// eye = target + distance (cos e cos a, cos e sin a, sin e); e stays off the poles, where the picture would
// spin.
#include "view/orbit.h"

#include <algorithm>
#include <cmath>

namespace epode::view {

namespace {

constexpr double kMostElevation = 1.55;
constexpr double kTurnRate = 0.006;  // radians a pixel
constexpr double kZoomRate = 0.88;   // of the distance, a notch
const viewer::Camera kLens;

double half_opening() { return std::tan(double(kLens.fov) * scenes::kPi / 360); }

}  // namespace

void Orbit::look(Vec eye, Vec target)
{
    const Vec back = eye - target;
    const double distance = scenes::length(back);
    if (!(distance > 1e-6) || !std::isfinite(distance)) return;
    target_ = target;
    distance_ = distance;
    elevation_ = std::clamp(std::asin(back.z / distance), -kMostElevation, kMostElevation);
    azimuth_ = std::atan2(back.y, back.x);
}

void Orbit::turn(double dx, double dy)
{
    azimuth_ -= kTurnRate * dx;
    elevation_ = std::clamp(elevation_ + kTurnRate * dy, -kMostElevation, kMostElevation);
}

void Orbit::pan(double dx, double dy, int height)
{
    Vec right, up, forward;
    axes(right, up, forward);
    const double scale = 2 * half_opening() * distance_ / std::max(height, 1);
    target_ = target_ - (scale * dx) * right + (scale * dy) * up;
}

void Orbit::zoom(double notches)
{
    distance_ = std::clamp(distance_ * std::pow(kZoomRate, notches), 1e-3, 1e5);
}

Vec Orbit::eye() const
{
    const double c = std::cos(elevation_);
    return target_ + distance_ * Vec{c * std::cos(azimuth_), c * std::sin(azimuth_), std::sin(elevation_)};
}

void Orbit::axes(Vec& right, Vec& up, Vec& forward) const
{
    forward = (1 / distance_) * (target_ - eye());
    right = {-std::sin(azimuth_), std::cos(azimuth_), 0};
    up = scenes::cross(right, forward);
}

Vec Orbit::aside(int height) const
{
    Vec right, up, forward;
    axes(right, up, forward);
    return (-offset_ * 2 * half_opening() * distance_ / std::max(height, 1)) * right;
}

viewer::Camera Orbit::camera(int height) const
{
    viewer::Camera camera;
    const Vec shift = aside(height), from = eye() + shift, to = target_ + shift;
    const double e[3] = {from.x, from.y, from.z}, t[3] = {to.x, to.y, to.z};
    for (int i = 0; i < 3; ++i) {
        camera.eye[i] = float(e[i]);
        camera.target[i] = float(t[i]);
    }
    return camera;
}

Ray Orbit::ray(double x, double y, int width, int height) const
{
    Vec right, up, forward;
    axes(right, up, forward);
    const double scale = 2 * half_opening() / std::max(height, 1);
    const Vec along = forward + (scale * (x - 0.5 * width)) * right - (scale * (y - 0.5 * height)) * up;
    return {eye() + aside(height), (1 / scenes::length(along)) * along};
}

}  // namespace epode::view
