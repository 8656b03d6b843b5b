// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Characters in narrow and random places: passages, acute corners, rubble of boxes, meshes and height fields.
// They never come closer to anything that stands than half the skin, whatever they are asked for.
#include "stage.h"

#include <random>

namespace epode::characters {
namespace {

class Narrow : public EveryCharacter {};
INSTANTIATE_TEST_SUITE_P(shapes, Narrow, testing::ValuesIn(cases()), case_name);

double gap(dGeomID a, dGeomID b)
{
    dQueryDistance d;
    return dGeomGetDistance(a, b, 1, &d) ? double(d.distance) : 1.0;
}

TEST_P(Narrow, goes_through_a_passage_that_is_a_little_wider_than_itself)
{
    Stage stage;
    stage.floor();
    const double half = 0.3 + 0.01 + 0.005;  // 5 mm more than the skin on each side
    stage.box({0, half + 1, 2}, {6, 2, 4});
    stage.box({0, -half - 1, 2}, {6, 2, 4});
    const dGeomID c = stage.add({-5, 0.001, 0}, settings());
    for (int i = 0; i * h() < 4; ++i) walk(c, {3, 0.2 * ((i / 10) % 2 ? 1 : -1), 0}, 0, h());
    EXPECT_GT(feet(c).x, 5);
}

TEST_P(Narrow, stops_in_an_acute_corner_and_gets_out_of_it)
{
    Stage stage;
    stage.floor();
    for (const int side : {1, -1}) {  // two walls that meet at 30 degrees, at x = 4 or so
        const dGeomID wall = stage.box({0, 0, 2}, {10, 1, 4});
        dMatrix3 R;
        dRFromAxisAndAngle(R, 0, 0, 1, dReal(-side * 0.26));
        dGeomSetRotation(wall, R);
        dGeomSetPosition(wall, 0, dReal(side * 1.5), 2);
    }
    const dGeomID c = stage.add({0, 0, 0}, settings());
    for (int i = 0; i * h() < 4; ++i) walk(c, {3, 0.3, 0}, 0, h());
    const V in = feet(c);
    for (int i = 0; i * h() < 1; ++i) {
        walk(c, {3, 0.3, 0}, 0, h());
        EXPECT_LE(norm(feet(c) - in), 1e-3);
    }
    for (int i = 0; i * h() < 1; ++i) walk(c, {-2, 0, 0}, 0, h());
    EXPECT_NEAR(in.x - feet(c).x, 2, 0.1);
}

struct Rubble {
    explicit Rubble(Stage& stage, unsigned seed) : random(seed)
    {
        const auto bump = [](double x, double y) {
            return 0.6 * std::sin(1.7 * x) * std::cos(1.3 * y) - 0.2;
        };
        all.push_back(stage.grid(24, 12, bump));
        for (int i = 0; i < 40; ++i) {
            const V centre = {at(5.5), at(5.5), at(1) + 0.8};
            const V size = {0.2 + std::fabs(at(1.2)), 0.2 + std::fabs(at(1.2)), 0.1 + std::fabs(at(1))};
            dGeomID g = i % 4 == 0   ? dCreateSphere(stage.space, dReal(size.x / 2))
                        : i % 4 == 1 ? dCreateCylinder(stage.space, dReal(size.x / 2), dReal(size.z))
                                     : stage.box({}, size);
            dMatrix3 R;
            dRFromAxisAndAngle(R, dReal(at(1)), dReal(at(1)), dReal(at(1) + 2), dReal(at(3)));
            dGeomSetRotation(g, R);
            dGeomSetPosition(g, dReal(centre.x), dReal(centre.y), dReal(centre.z));
            all.push_back(g);
        }
        for (const int side : {1, -1}) {
            all.push_back(stage.box({side * 6.5, 0, 0}, {1, 14, 1000}));
            all.push_back(stage.box({0, side * 6.5, 0}, {14, 1, 1000}));
        }
    }
    double at(double size) { return std::uniform_real_distribution<double>(-size, size)(random); }
    std::mt19937 random;
    std::vector<dGeomID> all;
};

// 11,000 random walks, leaps and flights a case: 1e5 together.
TEST_P(Narrow, never_comes_closer_than_the_skin_in_random_moves)
{
    Stage stage;
    Rubble rubble(stage, 7);
    const dGeomID c = stage.add({0, 0, 4}, settings());
    V v;
    double jump = 0, nearest = 1;
    int on_ground = 0;
    for (int i = 0; i < 11000; ++i) {
        if (i % 40 == 0) v = {rubble.at(6), rubble.at(6), 0}, jump = rubble.at(1) > 0.5 ? 5 : 0;
        if (i % 1500 == 1499) v = {rubble.at(100), rubble.at(100), rubble.at(30)};
        const int state = i % 1500 == 1499 ? move(c, v, h()) : walk(c, v, jump, h());
        on_ground += state == dCharacterOnGround;
        const V f = feet(c);
        ASSERT_TRUE(std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z)) << i;
        ASSERT_GT(f.z, -1) << i;  // it is still above the mesh
        if (i % 7 == 0)
            for (const dGeomID g : rubble.all) nearest = std::min(nearest, gap(c, g));
    }
    EXPECT_GE(nearest, 0.005);
    EXPECT_GT(on_ground, 2000);
}

TEST_P(Narrow, frees_itself_from_where_it_was_put)
{
    Stage stage;
    stage.floor();
    const dGeomID wall = stage.box({1, 0, 1}, {1, 4, 2});
    const dGeomID c = stage.add({0.35, 0, -0.1}, settings());  // 15 cm in the wall, 10 in the floor
    walk(c, {}, 0, h());
    EXPECT_GE(gap(c, wall), 0.0099);
    EXPECT_GE(feet(c).z, -1e-4);
    EXPECT_EQ(report(c).overlap, 0);
}

TEST_P(Narrow, reports_that_it_is_squeezed)
{
    Stage stage;
    stage.floor();
    stage.box({0, 0, 1.6}, {4, 4, 1});  // 1.1 m of room
    const dGeomID c = stage.add({0, 0, 0}, settings());
    for (int i = 0; i < 10; ++i) walk(c, {1, 0, 0}, 0, h());
    EXPECT_GT(report(c).overlap, 0.05);
    EXPECT_TRUE(std::isfinite(feet(c).x));
}

TEST_P(Narrow, keeps_to_height_fields)
{
    Stage stage;
    std::vector<float> heights(33 * 33);
    for (int i = 0; i < 33; ++i)
        for (int j = 0; j < 33; ++j)
            heights[std::size_t(33 * i + j)] = float(0.3 * std::sin(0.7 * i) * std::cos(0.5 * j));
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildSingle(data, heights.data(), 0, 16, 16, 33, 33, 1, 0, 1, 0);
    const dGeomID field = dCreateHeightfield(stage.space, data, 1);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 0, 0, dReal(1.5707963267948966));
    dGeomSetRotation(field, R);
    const dGeomID c = stage.add({0, 0, 1}, settings());
    for (int i = 0; i * h() < 1; ++i) walk(c, {}, 0, h());
    for (int i = 0; i * h() < 6; ++i) {
        EXPECT_EQ(walk(c, {2 * std::cos(i * h()), 2 * std::sin(i * h()), 0}, 0, h()), dCharacterOnGround);
        EXPECT_LT(std::fabs(feet(c).z), 0.45);
    }
    EXPECT_EQ(report(c).ground, field);
    dGeomDestroy(field);
    dGeomHeightfieldDataDestroy(data);
}

}  // namespace
}  // namespace epode::characters
