// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// pictures_test PROGRAM_IN_C PROGRAM_IN_CPP: runs every.c and every.cpp without a screen and judges their
// pictures by what must be seen where: colours are compared by order, never by stored values. And a few
// scenes drawn in this process. Skipped where no EGL display can be opened.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "../viewer/png_reader.h"
#include "board.h"
#include "drawstuff/drawstuff.h"
#include "viewer/headless.h"
#include "viewpoint.h"

namespace {

using epode::drawstuff::Viewpoint;
namespace fs = std::filesystem;

std::string programs[2];

struct Rgb {
    int r, g, b;
    int sum() const { return r + g + b; }
};

struct Shot {
    Image image;
    Viewpoint viewpoint;

    Rgb pixel(int column, int row) const
    {
        const bool inside = column >= 0 && row >= 0 && column < image.width && row < image.height;
        EXPECT_TRUE(inside) << column << ' ' << row;
        if (!inside) return {0, 0, 0};
        const std::size_t at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                    static_cast<std::size_t>(column));
        return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
    }
    Rgb at(float x, float y, float z) const
    {
        const float point[3] = {x, y, z};
        float where[2] = {-1, -1};
        EXPECT_TRUE(
            project(viewpoint.camera(image.width, image.height), image.width, image.height, point, where));
        return pixel(static_cast<int>(where[0]), static_cast<int>(where[1]));
    }
    // Place in a cell of the board, at the height of its middle.
    Rgb cell(int column, int row, float x, float y, float z = 1) const
    {
        return at(BOARD_X(row) + x, BOARD_Y(column) + y, z);
    }
};

// Every point of a square of two `half` around the middle of a cell.
template <class Visit>
void over_cell(const Shot& shot, int column, int row, float half, float z, Visit visit)
{
    for (float x = -half; x <= half; x += 0.04f)
        for (float y = -half; y <= half; y += 0.04f) visit(shot.cell(column, row, x, y, z));
}

bool is_red(Rgb c) { return c.r > 2 * c.g && c.r > 2 * c.b && c.r > 90; }
bool is_green(Rgb c) { return c.g > 2 * c.r && c.g > 2 * c.b && c.g > 90; }
bool is_blue(Rgb c) { return c.b > 2 * c.r && c.b > 2 * c.g && c.b > 90; }
bool is_magenta(Rgb c) { return c.r > 2 * c.g && c.b > 2 * c.g && c.r > 90 && c.b > 90; }
bool is_yellow(Rgb c) { return c.r > 2 * c.b && c.g > 2 * c.b && c.r > 90 && c.g > 90; }
bool is_cyan(Rgb c) { return c.g > 2 * c.r && c.b > 2 * c.r && c.g > 90; }
bool is_orange(Rgb c) { return c.r > c.g + 25 && c.g > c.b + 25; }

class Folder {
  public:
    Folder()
    {
        static int count = 0;
        path_ = testing::TempDir() + "epode_drawstuff_" + std::to_string(getpid()) + "_" +
                std::to_string(count++);
        fs::create_directories(path_);
    }
    ~Folder()
    {
        std::error_code fault;
        fs::remove_all(path_, fault);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const std::string& path() const { return path_; }
    std::size_t files(const char* part) const
    {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(path_))
            count += entry.path().filename().string().find(part) != std::string::npos;
        return count;
    }

  private:
    std::string path_;
};

std::string text_of(const std::string& path)
{
    std::ofstream touch(path, std::ios::app);
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

struct Ended {
    int code;
    std::string out, err;
};
Ended run(const std::string& program, const std::string& surroundings, const std::string& arguments,
          const Folder& folder)
{
    const std::string out = folder.path() + "/out", err = folder.path() + "/err";
    const std::string command = "cd '" + folder.path() + "' && env EPODE_GL=egl " + surroundings + " '" +
                                program + "' " + arguments + " > out 2> err";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

// A picture of the board; the programs' flags make each one once.
const Shot& board(const std::string& flags, int program = 0)
{
    static std::map<std::pair<std::string, int>, Shot> shots;
    const auto [found, is_new] = shots.try_emplace({flags, program});
    Shot& shot = found->second;
    if (!is_new) return shot;
    const float eye[3] = BOARD_EYE, look[3] = BOARD_LOOK;
    shot.viewpoint.set(eye, look);
    const Folder folder;
    const Ended ended =
        run(programs[program], "EPODE_FRAMES=a/b EPODE_FRAME_COUNT=2 EPODE_FRAME_EVERY=2", flags, folder);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.out.find("frames 2 simulated 2 seconds 0.033"), 0u) << ended.out;
    EXPECT_FALSE(fs::exists(folder.path() + "/a/b/frame0001.png"));
    shot.image = read_png(folder.path() + "/a/b/frame0002.png");
    EXPECT_EQ(shot.image.width, BOARD_WIDTH);
    EXPECT_EQ(shot.image.height, BOARD_HEIGHT);
    return shot;
}

class Pictures : public testing::Test {
  protected:
    void SetUp() override
    {
        epode::viewer::Headless context;
        std::string error;
        if (!context.open(error)) GTEST_SKIP() << error;
    }
};

TEST_F(Pictures, every_shape_is_where_it_belongs_by_floats_and_by_doubles)
{
    const Shot& shot = board("-notex -noshadow");
    for (const int row : {0, 1}) {
        SCOPED_TRACE(row);
        for (const float side : {-1.0f, 1.0f}) {
            EXPECT_TRUE(is_red(shot.cell(0, row, side * 0.45f, side * 0.45f, 1.5f)));
            EXPECT_FALSE(is_red(shot.cell(0, row, side * 0.6f, 0, 1.5f)));
            EXPECT_TRUE(is_green(shot.cell(1, row, side * 0.4f, 0)));
            EXPECT_FALSE(is_green(shot.cell(1, row, side * 0.42f, side * 0.42f)));
            EXPECT_TRUE(is_blue(shot.cell(2, row, side * 0.3f, side * 0.3f, 1.5f)));
            EXPECT_FALSE(is_blue(shot.cell(2, row, side * 0.45f, side * 0.45f, 1.5f)));
            EXPECT_TRUE(is_magenta(shot.cell(3, row, 0, side * 0.6f)));
            EXPECT_FALSE(is_magenta(shot.cell(3, row, side * 0.6f, 0)));
            EXPECT_TRUE(is_yellow(shot.cell(4, row, 0.2f + side * 0.1f, -0.2f)));
            EXPECT_FALSE(is_yellow(shot.cell(4, row, -0.3f, 0.3f + side * 0.1f)));
            EXPECT_TRUE(is_cyan(shot.cell(5, row, side * 0.4f, -0.2f)));
            EXPECT_TRUE(is_cyan(shot.cell(5, row, side * 0.4f, 0.2f)));
            EXPECT_FALSE(is_cyan(shot.cell(5, row, side * 0.6f, 0)));
            EXPECT_TRUE(is_orange(shot.cell(6, row, side * 0.2f, side * 0.3f)));
            EXPECT_FALSE(is_orange(shot.cell(6, row, side * 0.6f, 0)));
            EXPECT_FALSE(is_red(shot.cell(7, row, side * 0.5f, 0.2f)));
        }
        EXPECT_TRUE(is_red(shot.cell(7, row, -0.5f, 0)) || is_red(shot.cell(7, row, -0.5f, 0.03f)));
        EXPECT_TRUE(is_red(shot.cell(7, row, 0.5f, 0)) || is_red(shot.cell(7, row, 0.5f, 0.03f)));
    }
}

// The pyramid's four sides face the sun differently, so they differ in brightness.
TEST_F(Pictures, faces_of_a_convex_solid_are_lit_by_their_direction)
{
    const Shot& shot = board("-notex -noshadow");
    const int to_sun = shot.cell(6, 0, 0.3f, 0, 1.32f).sum(),
              from_sun = shot.cell(6, 0, -0.3f, 0, 1.32f).sum();
    EXPECT_GT(to_sun, from_sun + 60);
}

TEST_F(Pictures, c_and_cpp_draw_the_same_picture)
{
    EXPECT_TRUE(board("").image.rgb == board("", 1).image.rgb);
}

TEST_F(Pictures, shadows_fall_along_the_light_and_can_be_switched_off)
{
    const Shot &with = board("-notex"), &without = board("-notex -noshadows");
    // The middle of the box's upper side, carried along (1, 0.4, 1) to the floor.
    const Rgb dark = with.at(BOARD_X(0) - 1.5f, BOARD_Y(0) - 0.6f, 0),
              lit = with.at(BOARD_X(0) - 2.6f, BOARD_Y(0) - 0.6f, 0);
    EXPECT_LT(dark.sum(), 0.75 * lit.sum());
    EXPECT_GT(without.at(BOARD_X(0) - 1.5f, BOARD_Y(0) - 0.6f, 0).sum(), 0.95 * lit.sum());
    EXPECT_NEAR(without.cell(0, 0, 0, 0, 1.5f).sum(), with.cell(0, 0, 0, 0, 1.5f).sum(), 12);
}

// Spread of brightness over the middle of a plate.
struct Spread {
    double mean[3] = {0, 0, 0}, deviation = 0;
};
Spread spread(const Shot& shot, int column)
{
    Spread result;
    double count = 0, sum = 0, squares = 0;
    over_cell(shot, column, 2, 0.6f, 1.25f, [&](Rgb c) {
        ++count;
        result.mean[0] += c.r;
        result.mean[1] += c.g;
        result.mean[2] += c.b;
        sum += c.sum();
        squares += c.sum() * c.sum();
    });
    for (double& mean : result.mean) mean /= count;
    result.deviation = std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)));
    return result;
}

TEST_F(Pictures, textures_vary_and_can_be_switched_off)
{
    const Shot &with = board(""), &without = board("-notex");
    for (int column = 0; column < 4; ++column) {
        SCOPED_TRACE(column);
        EXPECT_GT(spread(with, column).deviation, 4);
        EXPECT_LT(spread(without, column).deviation, 2);
    }
    const Spread wood = spread(with, 0), squares = spread(with, 1), grass = spread(with, 2),
                 sky = spread(with, 3);
    EXPECT_GT(wood.mean[0], wood.mean[2] + 20) << "wood is brown";
    EXPECT_GT(squares.deviation, 60) << "black and white";
    EXPECT_GT(grass.mean[1], grass.mean[2] + 10) << "the ground is green";
    EXPECT_GT(sky.mean[2], sky.mean[0]) << "the sky is blue";
}

TEST_F(Pictures, the_translucent_lets_through_what_is_behind)
{
    const Shot& shot = board("-notex -noshadow");
    const Rgb through = shot.cell(4, 2, 0, 0), plate = shot.cell(4, 2, 0.65f, 0.65f, 0.55f);
    EXPECT_TRUE(is_red(plate));
    EXPECT_GT(through.b, plate.b + 50);
    EXPECT_GT(through.r, through.g + 40);
    EXPECT_LT(through.r, plate.r - 20);
}

TEST_F(Pictures, wires_are_thinner_than_surfaces)
{
    const Shot& shot = board("-notex -noshadow");
    for (const int column : {5, 6}) {
        int red = 0, all = 0;
        over_cell(shot, column, 2, 0.25f, 1, [&](Rgb c) {
            red += c.r > c.g + 40;
            ++all;
        });
        EXPECT_GT(red, 0.05 * all) << column;
        EXPECT_LT(red, 0.9 * all) << column;
    }
    int blue = 0;
    over_cell(shot, 6, 2, 0.1f, 1, [&](Rgb c) { blue += is_blue(c); });
    EXPECT_GT(blue, 0) << "what is inside is seen between the wires";
    int yellow = 0;
    for (float y = -0.6f; y <= -0.4f; y += 0.02f) yellow += is_yellow(shot.cell(7, 2, 0.2f, y));
    EXPECT_GT(yellow, 0) << "the outline of a square";
    EXPECT_FALSE(is_yellow(shot.cell(7, 2, 0.25f, 0))) << "its middle";
}

TEST_F(Pictures, nonsense_spoils_nothing)
{
    const Shot& shot = board("-notex -noshadow");
    over_cell(shot, 1, 0, 0.3f, 1,
              [](Rgb c) { EXPECT_TRUE(is_green(c)) << c.r << ' ' << c.g << ' ' << c.b; });
    over_cell(shot, 1, 0, 0.9f, 0, [](Rgb c) { EXPECT_GT(c.sum(), 150) << "something black"; });
}

TEST_F(Pictures, runs_end_by_ds_stop_and_write_what_is_asked)
{
    const Folder folder;
    const Ended ended =
        run(programs[0], "EPODE_FRAMES=. EPODE_FRAME_EVERY=2 EPODE_FRAME_COUNT=0", "stop 5 -pause", folder);
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.out, "frames 5 simulated 0 seconds 0.000\n");
    EXPECT_EQ(folder.files(".png"), 2u);
    EXPECT_TRUE(fs::exists(folder.path() + "/frame0004.png"));
    const Folder plain;
    EXPECT_EQ(run(programs[0], "EPODE_FRAMES= EPODE_FRAME_COUNT=1000", "", plain).out,
              "frames 1000 simulated 1000 seconds 16.667\n");
    EXPECT_EQ(plain.files("frame"), 0u);
}

// In this process: close to the pyramids, with the sky, and a floor of the program's own.
const float* eye = nullptr;
const float* look = nullptr;
void place_camera() { dsSetViewpoint(eye, look); }

Shot draw_here(const float (&place)[3], const float (&angles)[3], std::vector<const char*> arguments,
               const char* textures)
{
    const Folder folder;
    setenv("EPODE_GL", "egl", 1);
    setenv("EPODE_FRAMES", folder.path().c_str(), 1);
    setenv("EPODE_FRAME_COUNT", "1", 1);
    eye = place;
    look = angles;
    dsFunctions functions = {DS_VERSION, place_camera, nullptr, nullptr, nullptr, textures};
    arguments.insert(arguments.begin(), "here");
    dsSimulationLoop(static_cast<int>(arguments.size()), const_cast<char**>(arguments.data()), 320, 240,
                     &functions);
    Shot shot;
    shot.image = read_png(folder.path() + "/frame0001.png");
    shot.viewpoint.set(place, angles);
    EXPECT_EQ(shot.image.width, 320);
    return shot;
}

TEST_F(Pictures, nine_pyramids_stand_round_the_origin)
{
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; y += x == 0 ? 1 : 2) {
            const float place[3] = {static_cast<float>(x) + 0.3f, static_cast<float>(y), 0.2f},
                        angles[3] = {180, -25, 0};
            const Shot shot = draw_here(place, angles, {"-notex"}, nullptr);
            const Rgb side = shot.at(static_cast<float>(x) + 0.015f, static_cast<float>(y), 0.02f);
            SCOPED_TRACE(testing::Message() << x << ' ' << y);
            EXPECT_EQ(is_blue(side), x == 0 && y == 1);
            EXPECT_EQ(is_yellow(side), !(x == 0 && y == 1));
            EXPECT_FALSE(is_yellow(shot.at(static_cast<float>(x) + 0.06f, static_cast<float>(y), 0)));
        }
    }
    const float place[3] = {1.3f, 0, 0.2f}, angles[3] = {180, -25, 0};
    EXPECT_TRUE(is_red(draw_here(place, angles, {"-notex"}, nullptr).at(1.015f, 0, 0.02f)));
}

TEST_F(Pictures, the_sky_is_above_and_the_floor_ends)
{
    const float place[3] = {0, 0, 1}, level[3] = {0, 0, 0};
    const Shot shot = draw_here(place, level, {}, nullptr);
    const Rgb sky = shot.pixel(160, 5), floor = shot.pixel(160, 235);
    EXPECT_GT(sky.b, sky.r);
    EXPECT_GT(floor.g, floor.b);
    const float outside[3] = {150, 0, 1}, away[3] = {0, -20, 0};
    const Rgb nothing = draw_here(outside, away, {"-notex"}, nullptr).pixel(160, 235);
    EXPECT_GT(nothing.b, nothing.r) << "beyond the floor there is none";
}

TEST_F(Pictures, textures_of_the_program_are_used)
{
    const Folder textures;
    for (const char* name : {"wood", "checkered", "ground", "sky"}) {
        std::ofstream file(textures.path() + "/" + name + ".ppm", std::ios::binary);
        file << "P6 1 1 255\n" << (std::string(name) == "ground" ? "\xff\x01\x01" : "\x01\x01\xff");
    }
    const float place[3] = {5, 5, 3}, down[3] = {0, -60, 0};
    EXPECT_TRUE(is_red(draw_here(place, down, {}, textures.path().c_str()).pixel(160, 200)));
    EXPECT_TRUE(is_red(
        draw_here(place, down, {"-texturepath", textures.path().c_str()}, "/nowhere").pixel(160, 200)));
    fs::remove(textures.path() + "/sky.ppm");
    testing::internal::CaptureStderr();
    EXPECT_FALSE(is_red(draw_here(place, down, {}, textures.path().c_str()).pixel(160, 200)))
        << "all four or none";
    EXPECT_NE(testing::internal::GetCapturedStderr().find("sky.ppm is missing"), std::string::npos);
}

}  // namespace

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    if (argc != 3) {
        std::fprintf(stderr, "usage: pictures_test PROGRAM_IN_C PROGRAM_IN_CPP\n");
        return 2;
    }
    programs[0] = fs::absolute(argv[1]).string();
    programs[1] = fs::absolute(argv[2]).string();
    return RUN_ALL_TESTS();
}
