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
constexpr double kAir = 0.94;        // of the view's half, for the middle of what it holds
const viewer::Camera kLens;

// Of the composed view, upwards.
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

// A point (u, v, w) along right, up and back from the target is inside while |u| and |v| are at most the
// view's half width and height at its depth: t (distance - w), t the tangent of the half opening.
void Orbit::hold(const std::vector<Vec>& points)
{
    if (points.empty()) return;
    Vec right, up, forward;
    axes(right, up, forward);
    const double tangent = kAir * half_opening();
    std::vector<double> needed;
    for (const Vec& point : points) {
        const Vec to = point - target_;
        const double across = std::abs(scenes::dot(to, right)) / kAspect,
                     upward = std::abs(scenes::dot(to, up));
        needed.push_back(std::max(across, upward) / tangent - scenes::dot(to, forward));
    }
    const auto last = needed.begin() + std::ptrdiff_t(std::ceil(0.98 * double(needed.size() - 1)));
    std::nth_element(needed.begin(), last, needed.end());
    if (std::isfinite(*last)) distance_ = std::max(distance_, *last);
}

void Orbit::turn(double dx, double dy)
{
    azimuth_ -= kTurnRate * dx;
    elevation_ = std::clamp(elevation_ + kTurnRate * dy, -kMostElevation, kMostElevation);
}

void Orbit::pan(double dx, double dy)
{
    Vec right, up, forward;
    axes(right, up, forward);
    const double scale = pixel() * distance_;
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

void Orbit::set_area(const WindowArea& area)
{
    area_ = area;
    area_.clear_width = std::max(area.clear_width, 1.0);
    area_.clear_height = std::max(area.clear_height, 1.0);
}

double Orbit::pixel() const
{
    return 2 * half_opening() / std::min(area_.clear_height, area_.clear_width / kAspect);
}

viewer::Camera Orbit::camera() const
{
    viewer::Camera camera;
    const Vec from = eye();
    const double e[3] = {from.x, from.y, from.z}, t[3] = {target_.x, target_.y, target_.z};
    for (int i = 0; i < 3; ++i) {
        camera.eye[i] = float(e[i]);
        camera.target[i] = float(t[i]);
    }
    const double width = std::max(area_.width, 1), height = std::max(area_.height, 1);
    camera.fov = float(std::atan(0.5 * pixel() * height) * 360 / scenes::kPi);
    camera.shift[0] = float((2 * area_.left + area_.clear_width) / width - 1);
    camera.shift[1] = float(1 - (2 * area_.top + area_.clear_height) / height);
    return camera;
}

Ray Orbit::ray(double x, double y) const
{
    Vec right, up, forward;
    axes(right, up, forward);
    const double across = x - area_.left - 0.5 * area_.clear_width,
                 down = y - area_.top - 0.5 * area_.clear_height;
    const Vec along = forward + (pixel() * across) * right - (pixel() * down) * up;
    return {eye(), (1 / scenes::length(along)) * along};
}

}  // namespace epode::view
