// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Lines of a picture: what is thin in it.
#pragma once

#include "view/session/session.h"
#include "viewer/picture.h"

namespace epode::view {

constexpr viewer::Color kRed{0.86f, 0.20f, 0.16f}, kGreen{0.20f, 0.62f, 0.22f}, kBlue{0.16f, 0.36f, 0.86f},
    kYellow{0.98f, 0.78f, 0.10f}, kDark{0.13f, 0.13f, 0.16f}, kMagenta{0.80f, 0.18f, 0.62f},
    kGray{0.45f, 0.45f, 0.48f}, kOrange{0.95f, 0.50f, 0.08f};

class Lines {
  public:
    explicit Lines(std::vector<viewer::Line>& to) : to_(to) {}
    void line(Vec a, Vec b, viewer::Color color);
    // Its head lies in the plane of the shaft and `side`.
    void arrow(Vec from, Vec by, viewer::Color color);
    void cross(Vec at, double size, viewer::Color color);
    void box(Vec low, Vec high, viewer::Color color);
    // From angle to angle about the axis, 0 being along `zero`.
    void arc(Vec center, Vec axis, Vec zero, double radius, double from, double to, viewer::Color color);

  private:
    std::vector<viewer::Line>& to_;
};

// A unit vector at right angles to one of any length but zero.
Vec across(Vec v);
Vec unit(Vec v);

}  // namespace epode::view
