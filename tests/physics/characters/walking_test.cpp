// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Characters on what does not move: walls, slopes, stairs, ledges, jumps, ceilings and seams, by closed forms.
#include "stage.h"

#include <algorithm>

namespace epode::characters {
namespace {

class Walking : public EveryCharacter {};
INSTANTIATE_TEST_SUITE_P(shapes, Walking, testing::ValuesIn(cases()), case_name);

TEST_P(Walking, goes_as_far_as_its_velocity_says_on_a_plane)
{
    Stage stage;
    stage.floor();
    const dGeomID c = stage.add({}, settings());
    const int n = int(1 / h() + 0.5);
    for (int i = 0; i < n; ++i) EXPECT_EQ(walk(c, {3, 1, 0}, 0, h()), dCharacterOnGround);
    EXPECT_NEAR(feet(c).x, 3, 3 * kRounding);
    EXPECT_NEAR(feet(c).y, 1, 3 * kRounding);
    EXPECT_NEAR(feet(c).z, 0, 1e-5);
}

TEST_P(Walking, slides_along_a_wall_by_the_projection_of_its_velocity)
{
    Stage stage;
    stage.floor();
    stage.box({2, 0, 1}, {1, 40, 4});  // its face is at x = 1.5
    const dGeomID c = stage.add({1, 0, 0}, settings());
    const int n = int(1 / h() + 0.5);
    for (int i = 0; i < n; ++i) walk(c, {2, 3, 0}, 0, h());
    EXPECT_NEAR(feet(c).x, 1.5 - 0.3 - 0.01, 1e-4);
    EXPECT_NEAR(feet(c).y, 3, 1e-6 + 3 * kRounding);
    EXPECT_NEAR(velocity(c).y, 3, 1e-6 + 1e3 * kRounding);
    EXPECT_EQ(report(c).hit_wall, 1);
}

// A floor that rises along x by the angle, as a mesh of many triangles.
double tilted(Stage& stage, double angle)
{
    stage.grid(20, 40, [&](double x, double) { return x * std::tan(angle); });
    return angle;
}

TEST_P(Walking, stands_still_on_a_slope_below_the_limit)
{
    Stage stage;
    tilted(stage, 0.8);
    const dGeomID c = stage.add({0, 0, 1}, settings());
    for (int i = 0; i < 400; ++i) walk(c, {}, 0, h());
    const V before = feet(c);
    for (int i = 0; i < 400; ++i) EXPECT_EQ(walk(c, {}, 0, h()), dCharacterOnGround);
    EXPECT_LE(norm(feet(c) - before), 1e-6);
    EXPECT_NEAR(report(c).ground_normal[2], std::cos(0.8), 1e-5);
}

// g sin(angle) along the slope, so x'' = - g sin(angle) cos(angle).
TEST_P(Walking, slides_down_a_slope_above_the_limit)
{
    Stage stage;
    const double angle = tilted(stage, 1.0);
    const dGeomID c = stage.add({5, 0, 5 * std::tan(angle) + 0.2}, settings());
    for (int i = 0; i * h() < 0.5; ++i) walk(c, {}, 0, h());
    ASSERT_EQ(report(c).state, dCharacterOnSteep);
    const double before = velocity(c).x;
    const int n = int(0.5 / h() + 0.5);
    for (int i = 0; i < n; ++i) EXPECT_EQ(walk(c, {}, 0, h()), dCharacterOnSteep);
    const double gained = -kGravity * std::sin(angle) * std::cos(angle) * n * h();
    EXPECT_NEAR(velocity(c).x - before, gained, 1e-3);
}

TEST_P(Walking, does_not_climb_what_is_too_steep)
{
    Stage stage;
    tilted(stage, 1.0);
    const dGeomID c = stage.add({0, 0, 1}, settings());
    for (int i = 0; i < 60; ++i) walk(c, {}, 0, h());
    const double before = feet(c).z;
    for (int i = 0; i < 200; ++i) walk(c, {4, 0, 0}, 0, h());
    EXPECT_LT(feet(c).z, before);
}

TEST_P(Walking, keeps_its_horizontal_speed_uphill_and_downhill)
{
    Stage stage;
    tilted(stage, 0.5);
    const dGeomID c = stage.add({0, 0, 0.3}, settings());
    for (int i = 0; i < 200; ++i) walk(c, {}, 0, h());
    for (const double speed : {2.0, -2.0}) {
        const V before = feet(c);
        const int n = int(1 / h() + 0.5);
        for (int i = 0; i < n; ++i) EXPECT_EQ(walk(c, {speed, 0, 0}, 0, h()), dCharacterOnGround);
        EXPECT_NEAR(feet(c).x - before.x, speed, 2e-3);
        EXPECT_NEAR(feet(c).z - before.z, speed * std::tan(0.5), 2e-3);
    }
}

// Ten steps of that height.
void stairs(Stage& stage, double rise)
{
    stage.floor();
    for (int i = 1; i <= 10; ++i) {
        const double top = i * rise;
        stage.box({1 + 0.4 * i + 5, 0, top / 2}, {10, 4, top});
    }
}

TEST_P(Walking, climbs_stairs_of_30_cm_and_comes_down_again)
{
    Stage stage;
    stairs(stage, 0.3);
    const dGeomID c = stage.add({}, settings());
    for (int i = 0; i * h() < 6; ++i) EXPECT_EQ(walk(c, {1.5, 0, 0}, 0, h()), dCharacterOnGround);
    EXPECT_NEAR(feet(c).z, 3.0, 1e-3);
    EXPECT_GT(feet(c).x, 8);
    for (int i = 0; i * h() < 6.5; ++i) EXPECT_EQ(walk(c, {-1.5, 0, 0}, 0, h()), dCharacterOnGround);
    EXPECT_NEAR(feet(c).z, 0, 1e-3);
    EXPECT_LT(feet(c).x, 1);
}

// What a climb needs to go beyond what was asked for is taken from the next moves.
TEST_P(Walking, climbs_stairs_as_fast_as_it_is_asked_to)
{
    for (const double v : {0.5, 1.9}) {
        Stage stage;
        stairs(stage, 0.3);
        const dGeomID c = stage.add({}, settings());
        double highest = 0, fastest = 0;
        for (int i = 0; i < int(8 / v / h()); ++i) {
            walk(c, {v, 0, 0}, 0, h());
            fastest = std::max(fastest, feet(c).x - v * (i + 1) * h());
            highest = std::max(highest, feet(c).z);
        }
        EXPECT_NEAR(highest, 3.0, 1e-3) << v;
        EXPECT_LT(fastest, 0.012) << v;
        EXPECT_NEAR(feet(c).x, v * int(8 / v / h()) * h(), 1e-6 + 100 * kRounding) << v;
    }
}

TEST_P(Walking, does_not_climb_stairs_of_35_cm)
{
    for (const double radius : {0.3, 0.4, 0.2}) {
        Stage stage;
        stairs(stage, 0.35);
        dCharacterSettings s = settings();
        s.radius = dReal(radius);
        const dGeomID c = stage.add({}, s);
        for (int i = 0; i * h() < 3; ++i) walk(c, {1.5, 0, 0}, 0, h());
        EXPECT_NEAR(feet(c).z, 0, 1e-3);
        EXPECT_LT(feet(c).x, 1.4);
    }
}

// The height of a jump is v^2 / (2 g). The highest of positions a step apart may miss it by g h^2 / 8.
TEST_P(Walking, jumps_to_the_height_of_its_parabola)
{
    Stage stage;
    stage.floor();
    const dGeomID c = stage.add({}, settings());
    walk(c, {}, 0, h());
    const double jump = 5;
    double highest = 0;
    for (int i = 0; i * h() < 1.2; ++i) {
        walk(c, {}, i == 0 ? jump : 0, h());
        highest = std::max(highest, feet(c).z);
    }
    const double top = jump * jump / (2 * kGravity);
    EXPECT_LE(highest, top + 1e-5);
    EXPECT_GE(highest, top - kGravity * h() * h() / 8 - 1e-5);
    EXPECT_EQ(report(c).state, dCharacterOnGround);
    EXPECT_NEAR(feet(c).z, 0, 1e-4);
}

TEST_P(Walking, is_stopped_by_a_ceiling_and_falls)
{
    Stage stage;
    stage.floor();
    stage.box({0, 0, 2.5}, {4, 4, 1});  // from 2 m on: 0.2 m above the head
    const dGeomID c = stage.add({}, settings());
    walk(c, {}, 0, h());
    double highest = 0;
    bool hit = false;
    int steps = 0;
    for (int i = 0; i * h() < 1; ++i) {
        const int state = walk(c, {}, i == 0 ? 5 : 0, h());
        highest = std::max(highest, feet(c).z);
        hit = hit || report(c).hit_ceiling;
        if (state == dCharacterOnGround && steps == 0) steps = i;
    }
    EXPECT_TRUE(hit);
    EXPECT_LE(highest, 0.2);
    EXPECT_GE(highest, 0.15);
    EXPECT_LT(steps * h(), 0.35 + 2 * h());  // sqrt(2 * 0.19 / g) down, 0.04 s up
}

TEST_P(Walking, loses_no_speed_on_a_flat_grid_of_triangles)
{
    Stage stage;
    stage.grid(200, 20, [](double, double) { return 0.0; });
    const dGeomID c = stage.add({-4, -1.234, 0}, settings());
    walk(c, {}, 0, h());
    double slowest = 3;
    for (int i = 0; i * h() < 2; ++i) {
        EXPECT_EQ(walk(c, {3, 0.7, 0}, 0, h()), dCharacterOnGround);
        slowest = std::min(slowest, velocity(c).x);
    }
    EXPECT_GE(slowest, 3 * (1 - 1e-3));
}

TEST_P(Walking, loses_no_speed_at_seams_of_boxes)
{
    Stage stage;
    for (int i = 0; i < 40; ++i)  // each a little higher or lower than the one before, as rounding makes them
        stage.box({0.25 * i - 2, 0, -0.5 + 1e-5 * (i % 3)}, {0.25, 8, 1});
    for (int i = 0; i < 40; ++i) stage.box({0.25 * i - 2, 1, 1}, {0.25, 1, 2});  // a wall, at y = 0.5
    const dGeomID c = stage.add({-1, 0.1, 0.001}, settings());
    for (int i = 0; i < 10; ++i) walk(c, {0, 1, 0}, 0, h());
    double slowest = 3;
    for (int i = 0; i * h() < 1.5; ++i) {
        EXPECT_EQ(walk(c, {3, 1, 0}, 0, h()), dCharacterOnGround);
        slowest = std::min(slowest, velocity(c).x);
    }
    EXPECT_GE(slowest, 3 * (1 - 1e-3));
}

TEST_P(Walking, leaves_a_ledge_and_lands_on_its_parabola)
{
    Stage stage;
    stage.floor();
    stage.box({-5, 0, 1}, {10, 4, 2});
    dCharacterSettings s = settings();
    s.air_acceleration = 0;
    const dGeomID c = stage.add({-2, 0, 2}, s);
    double left = 0;
    bool landed = false;
    for (int i = 0; i * h() < 4 && !landed; ++i) {
        const int state = walk(c, {2, 0, 0}, 0, h());
        if (state == dCharacterInAir && left == 0) left = feet(c).x;
        landed = left != 0 && state == dCharacterOnGround;
    }
    ASSERT_TRUE(landed);
    EXPECT_NEAR(feet(c).z, 0, 1e-3);
    EXPECT_NEAR(feet(c).x - left, 2 * std::sqrt(2 * 2 / kGravity), 4 * h() + 0.2);
}

TEST_P(Walking, crouches_and_stands_up_where_it_fits)
{
    Stage stage;
    stage.floor();
    stage.box({0, 0, 1.75}, {4, 4, 1});  // 1.25 m of room under it
    const dGeomID c = stage.add({-4, 0, 0}, settings());
    for (int i = 0; i * h() < 2; ++i) walk(c, {2, 0, 0}, 0, h());
    EXPECT_LT(feet(c).x, -2.2);  // it does not fit
    ASSERT_EQ(dCharacterSetHeight(c, dReal(1.2)), 1);
    for (int i = 0; i * h() < 1; ++i) walk(c, {2, 0, 0}, 0, h());
    EXPECT_GT(feet(c).x, -0.6);
    EXPECT_EQ(dCharacterSetHeight(c, dReal(1.8)), 0);
    for (int i = 0; i * h() < 2; ++i) walk(c, {2, 0, 0}, 0, h());
    EXPECT_GT(feet(c).x, 2.4);
    EXPECT_NEAR(feet(c).z, 0, 1e-4);
    EXPECT_EQ(dCharacterSetHeight(c, dReal(1.8)), 1);
    EXPECT_NEAR(feet(c).z, 0, 1e-4);
}

TEST_P(Walking, stands_up_next_to_a_wall)
{
    Stage stage;
    stage.floor();
    stage.box({1, 0, 2}, {1, 4, 4});
    const dGeomID c = stage.add({-1, 0, 0}, settings());
    ASSERT_EQ(dCharacterSetHeight(c, 1), 1);
    for (int i = 0; i * h() < 2; ++i) walk(c, {2, 1, 0}, 0, h());
    EXPECT_EQ(dCharacterSetHeight(c, dReal(1.8)), 1);
}

}  // namespace
}  // namespace epode::characters
