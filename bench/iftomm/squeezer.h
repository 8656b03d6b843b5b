// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Andrews' squeezer mechanism (Schiehlen, Multibody Systems Handbook, 1990; Hairer & Wanner, Solving Ordinary
// Differential Equations II, VII.7), as seven bodies of the plane: mass, inertia about the centre, and where
// its pins and its centre lie, at the published initial angles. That the pins meet there to 1e-9, and that
// the angles at t = 0.03 are those of the test set for DAE solvers, is what vouches for the constants.
#pragma once

#include <array>

namespace epode::iftomm::squeezer {

struct Point {
    double x, y;
};

struct Bar {
    double mass, inertia;
    Point centre;
};

constexpr int kBars = 7;
enum { kCrank, kLink, kTriangle, kBarEG, kBarAG, kBarHE, kBarAH };

struct Pin {
    int a, b;  // bars; b = -1: the ground
    Point at;
};

// beta, theta, gamma, phi, delta, omega, epsilon
constexpr std::array<double, 7> kStart = {-0.0617138900142764496, 0,
                                          0.455279819163070380,   0.222668390165885884,
                                          0.487364979543842550,   -0.222668390165885884,
                                          1.23054744454982119};
// The same at t = 0.03, published.
constexpr std::array<double, 7> kAt003 = {15.8107711962990,   -15.7563710598430, 0.0408222401307310,
                                          -0.534730116322695, 0.524409965880530, 0.534730116322695,
                                          1.04808074104226};

constexpr double kTorque = 0.033, kStiffness = 4530, kRest = 0.07785;
constexpr Point kC{0.014, 0.072};

std::array<Bar, kBars> bars(const std::array<double, 7>& angles);
std::array<Pin, 10> pins(const std::array<double, 7>& angles);
Point spring_end(const std::array<double, 7>& angles);  // D, on the triangle
std::array<double, kBars> bar_angles(const std::array<double, 7>& angles);

}  // namespace epode::iftomm::squeezer
