// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where drawstuff's camera looks, by points whose place in the picture is known.
#include "viewpoint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace epode::drawstuff;

Viewpoint at(float x, float y, float z, float h, float p, float r)
{
    const float xyz[3] = {x, y, z}, hpr[3] = {h, p, r};
    Viewpoint viewpoint;
    viewpoint.set(xyz, hpr);
    return viewpoint;
}

// Pixels from the middle of a window of 800 by 600: to the right and up. NaN behind the eye.
struct Seen {
    float right, up;
};
Seen seen(const Viewpoint& viewpoint, float x, float y, float z, int width = 800, int height = 600)
{
    const float point[3] = {x, y, z};
    float pixel[2];
    if (!project(viewpoint.camera(width, height), width, height, point, pixel)) return {NAN, NAN};
    return {pixel[0] - 0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height) - pixel[1]};
}

TEST(Viewpoint, heading_pitch_and_roll_turn_the_right_way)
{
    EXPECT_NEAR(seen(at(0, 0, 0, 0, 0, 0), 10, 0, 0).right, 0, 0.01);
    EXPECT_TRUE(std::isnan(seen(at(0, 0, 0, 0, 0, 0), -10, 0, 0).right));
    EXPECT_GT(seen(at(0, 0, 0, 0, 0, 0), 10, -1, 0).right, 10) << "looking along +x, -y is to the right";
    EXPECT_NEAR(seen(at(0, 0, 0, 90, 0, 0), 0, 10, 0).right, 0, 0.01)
        << "heading is counter-clockwise from above";
    EXPECT_NEAR(seen(at(0, 0, 0, 0, 45, 0), 10, 0, 10).up, 0, 0.01) << "pitch is up";
    EXPECT_LT(seen(at(0, 0, 0, 0, 10, 0), 10, 0, 0).up, -10);
    const Seen rolled = seen(at(0, 0, 0, 0, 0, 90), 10, 0, 1);
    EXPECT_LT(rolled.right, -10) << "rolled to the right, what is above is to the left";
    EXPECT_NEAR(rolled.up, 0, 0.01);
}

TEST(Viewpoint, opens_by_four_fifths_along_the_longer_side)
{
    const Viewpoint viewpoint = at(0, 0, 0, 0, 0, 0);
    EXPECT_NEAR(seen(viewpoint, 10, -8, 0).right, 400, 0.1);
    EXPECT_NEAR(seen(viewpoint, 10, -8, 0, 600, 800).right, 400, 0.1);
    EXPECT_NEAR(seen(viewpoint, 10, 0, 8, 600, 800).up, 400, 0.1);
}

TEST(Viewpoint, angles_are_wrapped)
{
    const Viewpoint viewpoint = at(0, 0, 0, 725, -190, 361);
    EXPECT_NEAR(viewpoint.hpr[0], 5, 1e-4);
    EXPECT_NEAR(viewpoint.hpr[1], 170, 1e-4);
    EXPECT_NEAR(viewpoint.hpr[2], 1, 1e-4);
}

TEST(Viewpoint, numbers_that_are_none_change_nothing)
{
    Viewpoint viewpoint = at(1, 2, 3, 4, 5, 6);
    const float bad[3] = {0, std::numeric_limits<float>::infinity(), 0}, good[3] = {7, 7, 7};
    viewpoint.set(bad, good);
    viewpoint.set(good, bad);
    EXPECT_EQ(viewpoint.xyz[0], 1);
    EXPECT_EQ(viewpoint.hpr[0], 4);
}

TEST(Viewpoint, the_mouse_moves_the_scene)
{
    Viewpoint viewpoint = at(0, 0, 1, 90, 0, 0);
    viewpoint.drag(kLeftButton, 10, 4);
    EXPECT_FLOAT_EQ(viewpoint.hpr[0], 95);
    EXPECT_FLOAT_EQ(viewpoint.hpr[1], 2);
    for (const int buttons : {kMiddleButton, kLeftButton | kRightButton}) {
        viewpoint = at(0, 0, 1, 90, 0, 0);
        viewpoint.drag(buttons, 100, 50);
        EXPECT_NEAR(viewpoint.xyz[0], -1, 1e-5) << "looking along +y, left is -x";
        EXPECT_NEAR(viewpoint.xyz[1], 0, 1e-5);
        EXPECT_NEAR(viewpoint.xyz[2], 1.5, 1e-5);
    }
    viewpoint = at(0, 0, 1, 90, 0, 0);
    viewpoint.drag(kRightButton, 100, 50);
    EXPECT_NEAR(viewpoint.xyz[0], -1, 1e-5);
    EXPECT_NEAR(viewpoint.xyz[1], 0.5, 1e-5);
    EXPECT_EQ(viewpoint.xyz[2], 1);
    viewpoint.drag(0, 100, 100);
    EXPECT_NEAR(viewpoint.xyz[1], 0.5, 1e-5);
}

}  // namespace
