// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See squeezer.h. Lengths in m, named as in the literature.
#include "squeezer.h"

#include <cmath>

namespace epode::iftomm::squeezer {
namespace {

constexpr double da = 0.0115, e = 0.02, ea = 0.01421, zf = 0.02, fa = 0.01421, rr = 0.007, ra = 0.00092;
constexpr double ss = 0.035, sa = 0.01874, sb = 0.01043, sc = 0.018, sd = 0.02;
constexpr double zt = 0.04, ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228, ub = 0.00449;
constexpr Point A{-0.06934, -0.00227}, B{-0.03635, 0.03273}, O{0, 0};

// p + x (cos, sin) + y (-sin, cos)
Point from(Point p, double angle, double x, double y)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {p.x + x * c - y * s, p.y + x * s + y * c};
}

}  // namespace

std::array<double, kBars> bar_angles(const std::array<double, 7>& q)
{
    return {q[0], q[0] + q[1], q[2], q[3] + q[4], q[4], q[5] + q[6], q[6]};
}

std::array<Bar, kBars> bars(const std::array<double, 7>& q)
{
    const auto angle = bar_angles(q);
    const Point F = from(O, angle[kCrank], rr, 0), G = from(A, angle[kBarAG], zt, 0);
    const Point H = from(A, angle[kBarAH], 0, -u);
    return {Bar{0.04325, 2.194e-6, from(O, angle[kCrank], ra, 0)},
            Bar{0.00365, 4.410e-7, from(F, angle[kLink], -da, 0)},
            Bar{0.02373, 5.255e-6, from(B, angle[kTriangle], sb, -sa)},
            Bar{0.00706, 5.667e-7, from(G, angle[kBarEG], 0, -(e - ea))},
            Bar{0.07050, 1.169e-5, from(A, angle[kBarAG], ta, tb)},
            Bar{0.00706, 5.667e-7, from(H, angle[kBarHE], zf - fa, 0)},
            Bar{0.05498, 1.912e-5, from(A, angle[kBarAH], -ub, -ua)}};
}

std::array<Pin, 10> pins(const std::array<double, 7>& q)
{
    const auto angle = bar_angles(q);
    const Point F = from(O, angle[kCrank], rr, 0), G = from(A, angle[kBarAG], zt, 0);
    const Point H = from(A, angle[kBarAH], 0, -u), E = from(B, angle[kTriangle], 0, -ss);
    return {Pin{kCrank, -1, O},        Pin{kCrank, kLink, F}, Pin{kTriangle, -1, B},
            Pin{kTriangle, kLink, E},  Pin{kBarAG, -1, A},    Pin{kBarAG, kBarEG, G},
            Pin{kBarEG, kTriangle, E}, Pin{kBarAH, -1, A},    Pin{kBarAH, kBarHE, H},
            Pin{kBarHE, kTriangle, E}};
}

Point spring_end(const std::array<double, 7>& q) { return from(B, q[2], sd, -sc); }

}  // namespace epode::iftomm::squeezer
