// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The loop between a surface that plays a script of keys, frame by frame, and a program that writes down what
// it gets. No OpenGL.
#include "loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using namespace epode::drawstuff;
using epode::viewer::Picture;
using epode::viewer::Texture;

constexpr float kUpright[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

class Script : public Surface {
  public:
    explicit Script(std::vector<std::vector<Event>> frames) : frames_(std::move(frames)) {}
    bool open(int, int, std::string&) override { return true; }
    bool next_frame(std::vector<Event>& events) override
    {
        if (next_ == frames_.size()) return false;
        events = frames_[next_++];
        seconds_ += 0.25;
        return true;
    }
    bool is_seen() const override { return true; }
    int width() const override { return 400; }
    int height() const override { return 300; }
    bool show(epode::viewer::Renderer&, std::string&) override { return true; }
    double seconds() const override { return seconds_; }

    double seconds_ = 0;

  private:
    std::vector<std::vector<Event>> frames_;
    std::size_t next_ = 0;
};

// What a run saw, and what it does in a step; functions of C know no object.
struct Diary {
    std::string pauses;  // one letter a frame: p paused, s simulating
    std::string keys;
    int starts = 0, stops = 0;
    std::vector<Picture> pictures;
    std::function<void()> in_step;
};
Diary diary;

void note_start() { ++diary.starts; }
void note_stop() { ++diary.stops; }
void note_key(int key) { diary.keys += static_cast<char>(key); }
void note_step(int pause)
{
    diary.pauses += pause ? 'p' : 's';
    const float origin[3] = {0, 0, 1};
    dsSetTexture(DS_WOOD);
    dsDrawSphere(origin, kUpright, 0.5f);
    if (diary.in_step) diary.in_step();
    diary.pictures.push_back(Loop::current()->picture());
}

Event control(char letter) { return {Event::Kind::kControl, letter}; }
Event key(char letter) { return {Event::Kind::kKey, letter}; }
Event drag(int buttons, int dx, int dy) { return {Event::Kind::kDrag, 0, buttons, dx, dy}; }

void run(std::vector<std::vector<Event>> frames, const Options& options = {},
         std::function<void()> in_step = {})
{
    diary = {};
    diary.in_step = std::move(in_step);
    Script script(std::move(frames));
    const dsFunctions functions = {DS_VERSION, note_start, note_step, note_key, note_stop, nullptr};
    Loop(script, nullptr, draw_list(), functions, options).run();
}

TEST(Loop, starts_steps_and_stops)
{
    run({{}, {}, {}});
    EXPECT_EQ(diary.starts, 1);
    EXPECT_EQ(diary.pauses, "sss");
    EXPECT_EQ(diary.stops, 1);
    EXPECT_EQ(Loop::current(), nullptr);
}

TEST(Loop, null_functions_are_not_called)
{
    Script script({{}, {key('a')}, {}});
    const dsFunctions functions = {DS_VERSION, nullptr, nullptr, nullptr, nullptr, nullptr};
    Loop(script, nullptr, draw_list(), functions, {}).run();
    EXPECT_EQ(script.seconds(), 0.75);
}

TEST(Loop, pauses_and_takes_one_step)
{
    run({{}, {control('P')}, {}, {control('O')}, {}, {control('P')}, {}});
    EXPECT_EQ(diary.pauses, "sppspss");
}

TEST(Loop, one_step_while_running_is_nothing)
{
    run({{control('O')}, {}, {control('P')}, {}});
    EXPECT_EQ(diary.pauses, "sspp");
}

TEST(Loop, may_begin_paused)
{
    Options options;
    options.paused = true;
    run({{}, {control('O'), control('O')}, {}}, options);
    EXPECT_EQ(diary.pauses, "psp");
}

TEST(Loop, plain_keys_go_to_the_program_and_control_keys_do_not)
{
    run({{key('a'), key(' '), key('~')}, {control('T'), control('Q'), key('p')}});
    EXPECT_EQ(diary.keys, "a ~p");
}

TEST(Loop, control_x_ends_before_the_next_frame)
{
    run({{}, {control('X'), key('z')}, {}});
    EXPECT_EQ(diary.pauses, "s");
    EXPECT_EQ(diary.stops, 1);
}

TEST(Loop, ds_stop_ends_after_the_frame)
{
    run({{}, {}, {}, {}}, {}, [] {
        if (diary.pauses.size() == 2) dsStop();
    });
    EXPECT_EQ(diary.pauses, "ss");
    EXPECT_EQ(diary.stops, 1);
}

TEST(Loop, textures_and_shadows_are_switched_by_keys_and_flags)
{
    run({{}, {control('T')}, {control('S')}, {control('T'), control('S')}});
    ASSERT_EQ(diary.pictures.size(), 4u);
    const bool textures[] = {true, false, false, true}, shadows[] = {true, true, false, true};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(diary.pictures[i].clouds, textures[i]) << i;
        EXPECT_EQ(diary.pictures[i].shapes[0].texture, textures[i] ? Texture::kWood : Texture::kNone) << i;
        EXPECT_EQ(diary.pictures[i].shadows, shadows[i]) << i;
    }
    Options options;
    options.textures = options.shadows = false;
    run({{}}, options);
    EXPECT_FALSE(diary.pictures[0].clouds);
    EXPECT_FALSE(diary.pictures[0].shadows);
}

TEST(Loop, the_mouse_moves_the_viewpoint_and_control_v_prints_it)
{
    testing::internal::CaptureStdout();
    run({{drag(kLeftButton, 20, -10)}, {drag(kRightButton, 0, 100)}, {control('V')}});
    const std::string printed = testing::internal::GetCapturedStdout();
    // From (2, 0, 1), looking along -x: ten degrees to the left of it, five down, then a metre forwards.
    const double turn = 190 * 3.14159265358979 / 180;
    char expected[100];
    std::snprintf(expected, sizeof expected, "Viewpoint = (%.4f,%.4f,1.0000,-170.0000,-5.0000,0.0000)\n",
                  2 + std::cos(turn), std::sin(turn));
    EXPECT_EQ(printed, expected);
    EXPECT_NE(diary.pictures[0].camera.eye[0], diary.pictures[1].camera.eye[0]);
}

TEST(Loop, each_frame_begins_white_plain_and_empty_but_for_the_pyramids)
{
    run({{}, {}}, {}, [] {
        const float place[3] = {0, 0, 3};
        if (diary.pauses.size() == 1) {
            dsSetColorAlpha(0.5f, 0, 0, 0.5f);
            dsSetTexture(DS_SKY);
        }
        dsDrawSphere(place, kUpright, 1);
    });
    const epode::viewer::Shape &first = diary.pictures[0].shapes[1], &second = diary.pictures[1].shapes[0];
    EXPECT_EQ(first.alpha, 0.5f);
    EXPECT_EQ(first.color.r, 0.5f);
    EXPECT_EQ(first.texture, Texture::kSky);
    EXPECT_EQ(second.alpha, 1);
    EXPECT_EQ(second.color.g, 1);
    EXPECT_EQ(diary.pictures[1].shapes.size(), 2u);
    EXPECT_EQ(diary.pictures[1].triangles.size(), 36u);
}

TEST(Loop, draw_mode_stays_and_is_not_for_the_pyramids)
{
    run({{}, {}}, {}, [] { dsSetDrawMode(DS_WIREFRAME); });
    dsSetDrawMode(DS_POLYFILL);
    EXPECT_FALSE(diary.pictures[0].shapes[0].wire);
    EXPECT_TRUE(diary.pictures[1].shapes[0].wire);
    for (const epode::viewer::Triangle& triangle : diary.pictures[1].triangles) EXPECT_FALSE(triangle.wire);
}

TEST(Loop, elapsed_time_is_since_the_last_call_and_keeps_its_bounds)
{
    std::vector<double> times;
    run({{}, {}, {}}, {}, [&] {
        times.push_back(dsElapsedTime());
        times.push_back(dsElapsedTime());
    });
    ASSERT_EQ(times.size(), 6u);
    EXPECT_EQ(times[0], 0.25);
    EXPECT_EQ(times[1], 1e-16);
    EXPECT_EQ(times[2], 0.25);
    run({{}, {}, {}, {}, {}, {}}, {}, [&] {
        if (diary.pauses.size() == 6) times.push_back(dsElapsedTime());
    });
    EXPECT_EQ(times.back(), 1);
}

TEST(Loop, shapes_have_their_sizes_in_our_order)
{
    run({{}}, {}, [] {
        const double place[3] = {1, 2, 3};
        const double turned[12] = {0, -1, 0, 9, 1, 0, 0, 9, 0, 0, 1, 9};
        dsDrawCapsule(place, turned, 0.7f, 0.2f);
        dsDrawCylinder(place, turned, 0.6f, 0.3f);
    });
    const epode::viewer::Shape &capsule = diary.pictures[0].shapes[1],
                               &cylinder = diary.pictures[0].shapes[2];
    EXPECT_EQ(capsule.size[0], 0.2f);
    EXPECT_EQ(capsule.size[1], 0.7f);
    EXPECT_EQ(capsule.rot[1], -1);
    EXPECT_EQ(capsule.pos[2], 3);
    EXPECT_EQ(cylinder.size[0], 0.3f);
    EXPECT_EQ(cylinder.size[1], 0.6f);
    EXPECT_EQ(cylinder.kind, epode::viewer::ShapeKind::kCylinder);
}

TEST(Loop, triangles_are_turned_into_the_world)
{
    run({{}}, {}, [] {
        const float place[3] = {1, 2, 3}, turned[12] = {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
        const float v[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        dsDrawTriangles(place, turned, v, 1, 1);
        dsDrawTriangles(place, turned, v, 1, 0);
    });
    const epode::viewer::Triangle& triangle = diary.pictures[0].triangles.back();
    EXPECT_EQ(diary.pictures[0].triangles.size(), 37u);
    EXPECT_EQ(triangle.corners[1].pos[0], 1);
    EXPECT_EQ(triangle.corners[1].pos[1], 3);
    EXPECT_EQ(triangle.corners[2].pos[0], 0);
    EXPECT_EQ(triangle.corners[2].normal[2], 1);
    EXPECT_EQ(triangle.corners[2].local[1], 1);
    EXPECT_EQ(diary.pictures[0].lines.size(), 3u);
}

}  // namespace
