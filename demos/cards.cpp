// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A house of cards: three tents and a floor under the next, held by friction alone, stands.
#include <cmath>

#include "stage.h"

constexpr double kLean = 18 * M_PI / 180, kLong = 0.9, kThick = 0.02;
static dGeomID cards[7];
static double heights[7];

static dGeomID card(double x, double z, double angle)
{
    const dGeomID made = demo::box(x, 0, z, kThick, 0.6, kLong, 700);
    dMatrix3 turned;
    dRFromAxisAndAngle(turned, 0, 1, 0, angle);
    dBodySetRotation(demo::body(made), turned);
    return demo::paint(made, 0.95f, 0.93f, 0.88f, DS_WOOD);
}

// Two cards that lean against each other at (x, z).
static void tent(int first, double x, double z)
{
    const double tall = 0.5 * (kLong * std::cos(kLean) + kThick * std::sin(kLean));
    const double apart = 0.5 * (kLong * std::sin(kLean) + kThick * std::cos(kLean));
    cards[first] = card(x - apart, z + tall, kLean);
    cards[first + 1] = card(x + apart, z + tall, -kLean);
}

static void build()
{
    const double width = kLong * std::sin(kLean) + kThick * std::cos(kLean);
    const double tall = kLong * std::cos(kLean) + kThick * std::sin(kLean);
    tent(0, -width, 0);
    tent(2, width, 0);
    cards[4] = card(0, tall + 0.5 * kThick, M_PI / 2);
    tent(5, 0, tall + kThick);
    for (int i = 0; i < 7; ++i) heights[i] = demo::place(cards[i])[2];
}

static void judge()
{
    for (int i = 0; i < 7; ++i) {
        const double now = demo::place(cards[i])[2];
        demo::claim(demo::near(now, heights[i], 0.03), "card %d went from %g m to %g m", i, heights[i], now);
    }
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{1.4f, -2.8f, 1.4f}, {116, -11, 0}, 4, build, judge});
}
