// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Renders small scenes and judges the PNG: where a world point must appear follows from project(), where a
// shadow must fall from the sun's direction by hand. Colours are compared by order (redder, darker), never by
// stored values: another driver may differ by a shade. Skipped only where no EGL display can be opened; every
// other failure to draw is a failure of the test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "png_reader.h"
#include "viewer/picture.h"

namespace {

using namespace epode::viewer;

constexpr Color kRed{0.85f, 0.10f, 0.08f};

struct Rgb {
    int r, g, b;
    int sum() const { return r + g + b; }
};

Rgb pixel_of(const Image& image, int x, int y)
{
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(x));
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

bool is_red(Rgb c) { return c.r > 2 * c.g && c.r > 2 * c.b && c.r > 60; }

Shape make_shape(ShapeKind kind, float a, float b, float c, float x, float y, float z)
{
    Shape shape;
    shape.kind = kind;
    shape.size[0] = a;
    shape.size[1] = b;
    shape.size[2] = c;
    shape.pos[0] = x;
    shape.pos[1] = y;
    shape.pos[2] = z;
    shape.color = kRed;
    return shape;
}

Picture empty_scene()
{
    Picture picture;
    picture.width = 640;
    picture.height = 360;
    picture.grid = 0;
    picture.camera = {{6, -5, 4}, {0, 0, 0.8f}, {0, 0, 1}, 45};
    return picture;
}

Picture box_scene()
{
    Picture picture = empty_scene();
    picture.shapes.push_back(make_shape(ShapeKind::kBox, 1, 1, 1, 0, 0, 0.5f));
    return picture;
}

class PictureTest : public testing::Test {
  protected:
    ~PictureTest() override { std::remove(path_.c_str()); }

    void draw(const Picture& picture)
    {
        picture_ = picture;
        std::string error;
        const bool drawn = write_png(picture, path_.c_str(), error);
        if (!drawn && error.find("no EGL display") != std::string::npos) GTEST_SKIP() << error;
        ASSERT_TRUE(drawn) << error;
        image_ = read_png(path_);
        ASSERT_EQ(image_.width, picture.width);
        ASSERT_EQ(image_.height, picture.height);
    }

    Rgb at(float x, float y, float z) const
    {
        const float point[3] = {x, y, z};
        float pixel[2] = {-1, -1};
        EXPECT_TRUE(project(picture_.camera, image_.width, image_.height, point, pixel));
        const int column = static_cast<int>(pixel[0]), row = static_cast<int>(pixel[1]);
        const bool inside = column >= 0 && row >= 0 && column < image_.width && row < image_.height;
        EXPECT_TRUE(inside) << "the point is outside the picture: " << pixel[0] << ' ' << pixel[1];
        return inside ? pixel_of(image_, column, row) : Rgb{0, 0, 0};
    }

    std::string path_ = testing::TempDir() + "epode_" +
                        testing::UnitTest::GetInstance()->current_test_info()->name() + ".png";
    Picture picture_;
    Image image_;
};

// GTEST_SKIP and ASSERT leave only the function they stand in; this leaves the test as well.
#define DRAW(picture)                                 \
    do {                                              \
        draw(picture);                                \
        if (IsSkipped() || HasFatalFailure()) return; \
    } while (false)

TEST_F(PictureTest, box_is_red_where_it_projects)
{
    DRAW(box_scene());
    EXPECT_TRUE(is_red(at(0, 0, 1)));
    EXPECT_TRUE(is_red(at(0, -0.5f, 0.5f)));
    EXPECT_TRUE(is_red(at(0.5f, 0, 0.5f)));
    EXPECT_FALSE(is_red(at(1.2f, -1.2f, 0)));
    EXPECT_FALSE(is_red(at(0, 0, 1.6f)));
}

TEST_F(PictureTest, shifted_lens_moves_everything_alike)
{
    Picture picture = box_scene();
    DRAW(picture);
    const Image straight = image_;
    picture.camera.shift[0] = 0.25f;  // 80 of 640 pixels
    picture.camera.shift[1] = -0.2f;  // 36 of 360 pixels down
    DRAW(picture);
    EXPECT_TRUE(is_red(at(0, 0, 1)));
    EXPECT_FALSE(is_red(at(0, 0, 1.6f)));
    int different = 0, seen = 0;
    for (int y = 0; y < 324; y += 3) {
        for (int x = 0; x < 560; x += 4) {
            const Rgb before = pixel_of(straight, x, y), after = pixel_of(image_, x + 80, y + 36);
            different += std::abs(before.sum() - after.sum()) > 24;
            ++seen;
        }
    }
    EXPECT_LT(different, seen / 100) << "sky, ground, shadow and box are moved by the same pixels";
}

TEST_F(PictureTest, sky_differs_from_ground)
{
    Picture picture = empty_scene();
    picture.camera.target[2] = 3;
    DRAW(picture);
    const Rgb sky = pixel_of(image_, 320, 3), ground = pixel_of(image_, 320, 355);
    EXPECT_GT(sky.b - sky.r, ground.b - ground.r + 15) << "the sky is bluer";
    EXPECT_GT(std::abs(sky.sum() - ground.sum()) + std::abs(sky.b - ground.b), 30);
}

TEST_F(PictureTest, shadow_is_darker_than_lit_ground)
{
    Picture picture = box_scene();
    picture.sun[0] = -0.6f;
    picture.sun[1] = -0.5f;
    picture.sun[2] = 0.8f;
    DRAW(picture);
    // The top's centre (0, 0, 1), carried along the sun's rays to z = 0.
    const Rgb shadow = at(0.75f, 0.625f, 0), lit = at(-0.75f, -0.625f - 1, 0);
    EXPECT_LT(shadow.sum(), 0.75 * lit.sum());
    EXPECT_FALSE(is_red(shadow));
    picture.sun[0] = 0.6f;
    picture.sun[1] = 0.5f;
    DRAW(picture);
    EXPECT_GT(at(0.75f, 0.625f, 0).sum(), 0.9 * lit.sum())
        << "with the sun turned round the same point is lit";
}

TEST_F(PictureTest, two_renders_are_identical)
{
    Picture picture = box_scene();
    for (int i = 0; i < 60; ++i) {
        const auto at_x = static_cast<float>(i % 8) - 4, at_y = static_cast<float>(i / 8) - 4;
        Shape shape = make_shape(static_cast<ShapeKind>(i % 4), 0.3f, 0.4f, 0.5f, at_x, at_y, 0.7f);
        shape.color = palette(i);
        picture.shapes.push_back(shape);
        picture.lines.push_back({{0, 0, 2}, {at_x, at_y, 0.7f}, palette(i + 1)});
    }
    DRAW(picture);
    const Image first = image_;
    DRAW(picture);
    EXPECT_TRUE(first.rgb == image_.rgb);
}

// Seen from above, each kind reaches as far as its size says, along the axes its rotation says. Local z is
// turned to world x, local x to world y, local y to world z: a transposed rotation would point the long axis
// to y.
TEST_F(PictureTest, every_kind_has_its_size_and_direction)
{
    constexpr float kTurn[12] = {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0};
    struct Case {
        ShapeKind kind;
        float size[3];
        float along_x, along_y;
    };
    const Case cases[] = {{ShapeKind::kSphere, {0.8f, 0, 0}, 0.8f, 0.8f},
                          {ShapeKind::kBox, {0.8f, 0.6f, 2.0f}, 1.0f, 0.4f},
                          {ShapeKind::kCapsule, {0.4f, 1.4f, 0}, 1.1f, 0.4f},
                          {ShapeKind::kCylinder, {0.5f, 1.8f, 0}, 0.9f, 0.5f}};
    for (const Case& c : cases) {
        Picture picture = empty_scene();
        picture.camera = {{0, 0, 40}, {0, 0, 0}, {0, 1, 0}, 6};
        picture.ground_height = -5;
        Shape shape = make_shape(c.kind, c.size[0], c.size[1], c.size[2], 0.3f, -0.2f, 0);
        std::copy(kTurn, kTurn + 12, shape.rot);
        picture.shapes.push_back(shape);
        DRAW(picture);
        SCOPED_TRACE(static_cast<int>(c.kind));
        for (const float side : {-1.0f, 1.0f}) {
            EXPECT_TRUE(is_red(at(0.3f + side * 0.95f * c.along_x, -0.2f, 0)));
            EXPECT_FALSE(is_red(at(0.3f + side * 1.05f * c.along_x, -0.2f, 0)));
            EXPECT_TRUE(is_red(at(0.3f, -0.2f + side * 0.95f * c.along_y, 0)));
            EXPECT_FALSE(is_red(at(0.3f, -0.2f + side * 1.05f * c.along_y, 0)));
        }
    }
}

TEST_F(PictureTest, lines_are_drawn_and_faint_behind_shapes)
{
    Picture picture = box_scene();
    const Color blue{0.05f, 0.10f, 0.90f};
    picture.lines.push_back({{0, -2, 0.5f}, {0, 2, 0.5f}, blue});
    DRAW(picture);
    const Rgb free = at(0, -1.2f, 0.5f), hidden = at(0, 0, 0.5f), face = at(0.5f, 0.25f, 0.25f);
    EXPECT_GT(free.b, 2 * free.r);
    EXPECT_GT(hidden.r, hidden.b) << "the box is in front";
    EXPECT_GT(hidden.b, face.b + 10) << "yet the line is guessed";
}

TEST_F(PictureTest, what_cannot_be_drawn_is_left_out)
{
    DRAW(box_scene());
    const Image clean = image_;
    Picture picture = box_scene();
    picture.shapes.push_back(
        make_shape(ShapeKind::kSphere, 1, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0));
    picture.shapes.push_back(make_shape(ShapeKind::kSphere, -1, 0, 0, 0, 0, 0));
    picture.shapes.push_back(make_shape(ShapeKind::kBox, 1, 0, 1, 0, 0, 0));
    picture.shapes.push_back(
        make_shape(ShapeKind::kCylinder, 1, std::numeric_limits<float>::infinity(), 0, 0, 0, 0));
    picture.shapes.push_back(make_shape(ShapeKind::kBox, 1, 1, 1, 0, 0, 2));
    picture.shapes.back().rot[5] = std::numeric_limits<float>::infinity();
    DRAW(picture);
    EXPECT_TRUE(clean.rgb == image_.rgb);
}

TEST_F(PictureTest, empty_scene_and_odd_sizes_are_drawn)
{
    Picture picture = empty_scene();
    picture.width = 3;
    picture.height = 1;
    DRAW(picture);
    picture.ground = false;
    picture.width = 101;
    picture.height = 77;
    DRAW(picture);
}

TEST(PictureErrors, are_said_in_words)
{
    const Picture good = box_scene();
    std::string error;
    EXPECT_FALSE(write_png(good, nullptr, error));
    EXPECT_NE(error.find("file name"), std::string::npos);
    for (const int width : {0, -5, kMaxPictureSide + 1}) {
        Picture picture = good;
        picture.width = width;
        EXPECT_FALSE(write_png(picture, "never.png", error));
        EXPECT_NE(error.find("width and height"), std::string::npos);
    }
    Picture blind = good;
    blind.camera.eye[1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(write_png(blind, "never.png", error));
    EXPECT_NE(error.find("camera"), std::string::npos);
}

TEST_F(PictureTest, unwritable_path_is_named)
{
    DRAW(box_scene());
    std::string error;
    EXPECT_FALSE(write_png(picture_, "/no/such/folder/a.png", error));
    EXPECT_NE(error.find("/no/such/folder/a.png"), std::string::npos);
}

TEST(Framing, holds_every_shape_and_wastes_little)
{
    std::vector<Shape> shapes;
    for (int i = 0; i < 40; ++i) {
        const auto t = static_cast<float>(i);
        shapes.push_back(make_shape(ShapeKind::kSphere, 0.2f, 0, 0, 5 * std::sin(t), 3 * std::cos(2 * t),
                                    1 + std::sin(3 * t)));
    }
    shapes.push_back(
        make_shape(ShapeKind::kSphere, std::numeric_limits<float>::quiet_NaN(), 0, 0, 1e9f, 0, 0));
    const Camera camera = frame_shapes(shapes, 16.0f / 9.0f);
    float low[2] = {1e9f, 1e9f}, high[2] = {-1e9f, -1e9f};
    for (std::size_t i = 0; i + 1 < shapes.size(); ++i) {
        float pixel[2];
        ASSERT_TRUE(project(camera, 1600, 900, shapes[i].pos, pixel));
        for (int k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], pixel[k]);
            high[k] = std::max(high[k], pixel[k]);
        }
    }
    EXPECT_GT(low[0], 0);
    EXPECT_LT(high[0], 1600);
    EXPECT_GT(low[1], 0);
    EXPECT_LT(high[1], 900);
    EXPECT_GT(std::max((high[0] - low[0]) / 1600, (high[1] - low[1]) / 900), 0.7f);
}

TEST(Framing, of_nothing_is_a_usable_camera)
{
    const Camera camera = frame_shapes({}, 1.5f);
    float pixel[2];
    EXPECT_TRUE(project(camera, 300, 200, camera.target, pixel));
    EXPECT_NEAR(pixel[0], 150, 0.01);
    EXPECT_NEAR(pixel[1], 100, 0.01);
}

TEST(Palette, repeats_and_takes_any_index)
{
    for (int i = -20; i < 20; ++i) {
        const Color a = palette(i), b = palette(i + 8), next = palette(i + 1);
        EXPECT_EQ(a.r, b.r);
        EXPECT_GT(std::fabs(a.r - next.r) + std::fabs(a.g - next.g) + std::fabs(a.b - next.b), 0.2f);
    }
}

}  // namespace
