// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Flags and surroundings; pictures read and written as PPM; textures of drawstuff's own making.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "options.h"
#include "ppm.h"

namespace {

using namespace epode;
using namespace epode::drawstuff;

Options read(std::vector<const char*> flags, int version = 2, const char* path = nullptr)
{
    flags.insert(flags.begin(), "program");
    dsFunctions functions = {version, nullptr, nullptr, nullptr, nullptr, path};
    return read_options(static_cast<int>(flags.size()), flags.data(), functions);
}

// A variable of the surroundings for as long as this lives; null: unset.
class Given {
  public:
    Given(const char* name, const char* value) : name_(name)
    {
        if (const char* old = std::getenv(name)) {
            old_ = old;
            had_ = true;
        }
        value ? setenv(name, value, 1) : unsetenv(name);
    }
    ~Given() { had_ ? setenv(name_, old_.c_str(), 1) : unsetenv(name_); }
    Given(const Given&) = delete;
    Given& operator=(const Given&) = delete;

  private:
    const char* name_;
    std::string old_;
    bool had_ = false;
};

TEST(Options, flags_are_drawstuffs)
{
    const Options none = read({"-something", "else", "-pauses"});
    EXPECT_TRUE(none.textures && none.shadows && !none.paused && none.texture_path.empty());
    EXPECT_FALSE(read({"-notex"}).textures);
    EXPECT_FALSE(read({"-noshadow"}).shadows);
    EXPECT_FALSE(read({"x", "-noshadows"}).shadows);
    EXPECT_TRUE(read({"-pause"}).paused);
    EXPECT_EQ(read({"-texturepath", "a/b"}, 2, "c").texture_path, "a/b");
    EXPECT_EQ(read({"-texturepath"}, 2, "c").texture_path, "c");
    EXPECT_EQ(read({}, 1, "c").texture_path, "") << "there was no path in version 1";
}

TEST(Options, a_window_only_where_there_is_a_screen_unless_asked_for)
{
    const Given no_wayland("WAYLAND_DISPLAY", nullptr);
    {
        const Given none("DISPLAY", nullptr), gl("EPODE_GL", nullptr);
        EXPECT_TRUE(read({}).headless);
    }
    const Given screen("DISPLAY", ":0");
    {
        const Given gl("EPODE_GL", nullptr);
        EXPECT_FALSE(read({}).headless);
    }
    {
        const Given gl("EPODE_GL", "egl");
        EXPECT_TRUE(read({}).headless);
    }
    const Given none("DISPLAY", nullptr), gl("EPODE_GL", "window");
    EXPECT_FALSE(read({}).headless);
}

TEST(Options, frames_are_counted_and_placed_by_the_surroundings)
{
    {
        const Given a("EPODE_FRAMES", nullptr), b("EPODE_FRAME_COUNT", nullptr),
            c("EPODE_FRAME_EVERY", nullptr);
        const Options options = read({});
        EXPECT_EQ(options.frame_folder, "frame");
        EXPECT_EQ(options.frame_count, 300);
        EXPECT_EQ(options.frame_every, 1);
    }
    const Given a("EPODE_FRAMES", ""), b("EPODE_FRAME_COUNT", "7"), c("EPODE_FRAME_EVERY", "3");
    const Options options = read({});
    EXPECT_EQ(options.frame_folder, "");
    EXPECT_EQ(options.frame_count, 7);
    EXPECT_EQ(options.frame_every, 3);
}

class PpmTest : public testing::Test {
  protected:
    ~PpmTest() override { std::remove(path_.c_str()); }
    bool read_text(const std::string& text)
    {
        std::ofstream(path_, std::ios::binary) << text;
        image_ = {};
        return read_ppm(path_, image_);
    }
    std::string path_ = testing::TempDir() + "epode_" +
                        testing::UnitTest::GetInstance()->current_test_info()->name() + ".ppm";
    viewer::Image image_;
};

TEST_F(PpmTest, comes_back_as_it_was_written)
{
    const viewer::Image image = {2, 1, {0, 10, 255, 35, 32, 10}};
    ASSERT_TRUE(write_ppm(path_, image));
    ASSERT_TRUE(read_ppm(path_, image_));
    EXPECT_EQ(image_.width, 2);
    EXPECT_EQ(image_.height, 1);
    EXPECT_EQ(image_.rgb, image.rgb);
    EXPECT_FALSE(write_ppm("/no/such/folder/a.ppm", image));
}

TEST_F(PpmTest, headers_may_have_comments_and_must_be_whole)
{
    EXPECT_TRUE(read_text("P6 # by hand\n1\n# two\n2 255\nabcdef"));
    EXPECT_EQ(image_.rgb[5], 'f');
    EXPECT_FALSE(read_text("P6 1 2 255\nabcde")) << "a byte is missing";
    EXPECT_FALSE(read_text("P5 1 2 255\nabcdef"));
    EXPECT_FALSE(read_text("P6 1 2 65535\nabcdef"));
    EXPECT_FALSE(read_text("P6 -1 2 255\nabcdef"));
    EXPECT_FALSE(read_text("P6 100000 100000 255\nabcdef"));
    EXPECT_FALSE(read_text("P6"));
    EXPECT_FALSE(read_text(""));
    EXPECT_FALSE(read_ppm("/no/such/file.ppm", image_));
}

TEST(Textures, fitting_keeps_means_and_colours)
{
    viewer::Image image{2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}};
    const viewer::Image large = viewer::fitted(image);
    ASSERT_EQ(large.rgb.size(), 3u * viewer::kTextureSide * viewer::kTextureSide);
    EXPECT_EQ(large.rgb[0], 255);
    EXPECT_EQ(large.rgb[1], 0);
    EXPECT_EQ(large.rgb[3 * (viewer::kTextureSide - 1) + 1], 255);
    viewer::Image wide{2 * viewer::kTextureSide, 1, {}};
    for (int i = 0; i < wide.width; ++i)
        for (const int c : {0, 100, 200}) wide.rgb.push_back(static_cast<std::uint8_t>(i % 2 ? c : 0));
    const viewer::Image halved = viewer::fitted(wide);
    EXPECT_EQ(halved.rgb[1], 50);
    EXPECT_EQ(halved.rgb[2], 100);
    EXPECT_TRUE(viewer::fitted({}).rgb.empty());
}

// Each varies, none is black or white, and the seams are no rougher than the inside.
TEST(Textures, ours_vary_and_have_no_seams)
{
    using viewer::Texture;
    constexpr int n = viewer::kTextureSide;
    for (const Texture texture : {Texture::kWood, Texture::kGround, Texture::kSky}) {
        const viewer::Image image = viewer::make_texture(texture);
        ASSERT_EQ(image.rgb.size(), 3u * n * n);
        const auto green = [&](int x, int y) {
            return static_cast<int>(image.rgb[3 * static_cast<std::size_t>((y % n) * n + x % n) + 1]);
        };
        const auto [low, high] = std::minmax_element(image.rgb.begin(), image.rgb.end());
        EXPECT_GT(*high - *low, 40) << static_cast<int>(texture);
        EXPECT_GT(*low, 40);
        long inside = 0, seam = 0;
        for (int i = 0; i < n; ++i) {
            inside += std::abs(green(n / 2, i) - green(n / 2 + 1, i)) +
                      std::abs(green(i, n / 3) - green(i, n / 3 + 1));
            seam += std::abs(green(n - 1, i) - green(n, i)) + std::abs(green(i, n - 1) - green(i, n));
        }
        EXPECT_LT(seam, 3 * inside + n) << static_cast<int>(texture);
    }
}

}  // namespace
