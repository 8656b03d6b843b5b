// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// HalfCheetah stands in the plane of x and y here, because a plane-2D joint holds it there; its geoms are given
// by centre, angle and half length, and its masses add up to 14 kg. Three hinges at one place of Humanoid are
// one ball here, two one universal joint.
#include "bench/problems/mechanism_models.h"

#include <cmath>

namespace epode::bench {
namespace {

constexpr double kDegree = 0.017453292519943295;

LinkAxis ant_axis(Point axis, double low, double high)
{
    return {axis, low * kDegree, high * kDegree, 1, 1, 0, 150};
}

// Leg towards (x, y); the ankle's axis has the sign that Gymnasium's file gives it.
void add_leg(std::vector<Link>& links, double x, double y, Point ankle, double low, double high)
{
    links[0].shapes.push_back({{0, 0, 0}, {x, y, 0}, 0.08});
    links.push_back({0, {x, y, 0}, {}, {ant_axis({0, 0, 1}, -30, 30)}, {{{0, 0, 0}, {x, y, 0}, 0.08}}});
    links.push_back({int(links.size()) - 1,
                     {x, y, 0},
                     {},
                     {ant_axis(ankle, low, high)},
                     {{{0, 0, 0}, {2 * x, 2 * y, 0}, 0.08}}});
}

MechanismModel ant()
{
    std::vector<Link> links{{-1, {}, {}, {}, {{{0, 0, 0}, {0, 0, 0}, 0.25}}}};
    const double s = std::sqrt(0.5);
    add_leg(links, 0.2, 0.2, {-s, s, 0}, 30, 70);
    add_leg(links, -0.2, 0.2, {s, s, 0}, -70, -30);
    add_leg(links, -0.2, -0.2, {-s, s, 0}, -70, -30);
    add_leg(links, 0.2, -0.2, {s, s, 0}, 30, 70);
    return {"ant", 0.01, 5, 1, 0.75, true, false, false, links};
}

// Turned by `angle` from the vertical y towards x.
LinkShape rod(double x, double y, double angle, double half)
{
    const double dx = half * std::sin(angle), dy = half * std::cos(angle);
    return {{x - dx, y - dy, 0}, {x + dx, y + dy, 0}, 0.046};
}

Link cheetah_link(int parent, Point origin, double low, double high, double damping, double stiffness,
                  double torque, LinkShape shape)
{
    return {parent, origin, {}, {{{0, 0, -1}, low, high, 0.1, damping, stiffness, torque}}, {shape}};
}

MechanismModel half_cheetah()
{
    std::vector<Link> links{
        {-1, {}, {}, {}, {{{-0.5, 0, 0}, {0.5, 0, 0}, 0.046}, rod(0.6, 0.1, 0.87, 0.15)}},
        cheetah_link(0, {-0.5, 0, 0}, -0.52, 1.05, 6, 240, 120, rod(0.1, -0.13, -3.8, 0.145)),
        cheetah_link(1, {0.16, -0.25, 0}, -0.785, 0.785, 4.5, 180, 90, rod(-0.14, -0.07, -2.03, 0.15)),
        cheetah_link(2, {-0.28, -0.14, 0}, -0.4, 0.785, 3, 120, 60, rod(0.03, -0.097, -0.27, 0.094)),
        cheetah_link(0, {0.5, 0, 0}, -1, 0.7, 4.5, 180, 120, rod(-0.07, -0.12, 0.52, 0.133)),
        cheetah_link(4, {-0.14, -0.24, 0}, -1.2, 0.87, 3, 120, 60, rod(0.065, -0.09, -0.6, 0.106)),
        cheetah_link(5, {0.13, -0.18, 0}, -0.5, 0.5, 1.5, 60, 30, rod(0.045, -0.07, -0.6, 0.07))};
    return {"half-cheetah", 0.01, 650, 0.4, 0.7, true, true, false, links};
}

LinkAxis human_axis(Point axis, double low, double high, double armature, double damping, double stiffness,
                    double torque)
{
    return {axis, low * kDegree, high * kDegree, armature, damping, stiffness, 0.4 * torque};
}

// The leg and the arm on one side, y or -y; the pelvis is link 2.
void add_side(std::vector<Link>& links, double y)
{
    const int hip = int(links.size());
    links.push_back(
        {2,
         {0, 0.1 * y, -0.04},
         {},
         {human_axis({-y, 0, 0}, -25, 5, 0.01, 5, 10, 100), human_axis({0, 0, -y}, -60, 35, 0.01, 5, 10, 100),
          human_axis({0, 1, 0}, -110, 20, 0.008, 5, 20, 300)},
         {{{0, 0, 0}, {0, -0.01 * y, -0.34}, 0.06}}});
    links.push_back({hip,
                     {0, -0.01 * y, -0.403},
                     {0, 0, 0.02},
                     {human_axis({0, -1, 0}, -160, -2, 0.006, 1, 1, 200)},
                     {{{0, 0, 0}, {0, 0, -0.3}, 0.049}, {{0, 0, -0.35}, {0, 0, -0.35}, 0.075}}});
    const double s = std::sqrt(0.5), t = std::sqrt(1.0 / 6);
    links.push_back({0,
                     {0, 0.17 * y, 0.06},
                     {},
                     {human_axis({2 * t, -t * y, t}, -85, 60, 0.0068, 1, 1, 25),
                      human_axis({0, s * y, s}, -85, 60, 0.0051, 1, 1, 25)},
                     {{{0, 0, 0}, {0.16, 0.16 * y, -0.16}, 0.04}}});
    links.push_back({hip + 2,
                     {0.18, 0.18 * y, -0.18},
                     {},
                     {human_axis({0, -s, -s * y}, -90, 50, 0.0028, 1, 0, 25)},
                     {{{0.01, -0.01 * y, 0.01}, {0.17, -0.17 * y, 0.17}, 0.031},
                      {{0.18, -0.18 * y, 0.18}, {0.18, -0.18 * y, 0.18}, 0.04}}});
}

MechanismModel humanoid()
{
    std::vector<Link> links{
        {-1,
         {},
         {},
         {},
         {{{0, -0.07, 0}, {0, 0.07, 0}, 0.07},
          {{0, 0, 0.19}, {0, 0, 0.19}, 0.09},
          {{-0.01, -0.06, -0.12}, {-0.01, 0.06, -0.12}, 0.06}}},
        {0,
         {-0.01, 0, -0.26},
         {0, 0, 0.065},
         {human_axis({0, 0, 1}, -45, 45, 0.02, 5, 20, 100), human_axis({0, 1, 0}, -75, 30, 0.02, 5, 10, 100)},
         {{{0, -0.06, 0}, {0, 0.06, 0}, 0.06}}},
        {1,
         {0, 0, -0.165},
         {0, 0, 0.1},
         {human_axis({1, 0, 0}, -35, 35, 0.02, 5, 10, 100)},
         {{{-0.02, -0.07, 0}, {-0.02, 0.07, 0}, 0.09}}}};
    add_side(links, -1);
    add_side(links, 1);
    return {"humanoid", 0.003, 1000, 1, 1.4, true, false, true, links};
}

MechanismModel free_body()
{
    return {"free-body", 0.01, 1000, 1, 1, false, false, false, {{-1, {}, {}, {}, {{{}, {}, 0.1}}}}};
}

MechanismModel box()
{
    return {"box", 0.01, 1000, 0.5, 0.1, true, false, false, {{-1, {}, {}, {}, {{{}, {0.1, 0.1, 0.1}, 0}}}}};
}

// Of links without stops, motors and contacts; the first hangs on the world.
MechanismModel chain()
{
    std::vector<Link> links;
    for (int i = 0; i < 8; ++i) {
        const double turn = 0.3 * i;
        links.push_back({i - 1,
                         {i ? 0.2 : 0.0, 0, 0},
                         {},
                         {{{0, std::cos(turn), std::sin(turn)}, 0, 0, 0, 0, 0, 0}},
                         {{{}, {0.2, 0, 0}, 0.03}}});
    }
    return {"chain", 0.01, 1000, 1, 3, false, false, false, links};
}

}  // namespace

std::span<const MechanismModel> mechanism_models()
{
    static const std::array models{ant(), half_cheetah(), humanoid(), free_body(), box(), chain()};
    return models;
}

}  // namespace epode::bench
