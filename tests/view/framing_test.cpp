// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What moves appears in the part of the window that no panel covers, in windows of any size; drawn nowhere:
// the camera of the viewer's picture tells where a point would appear, and Dear ImGui where the panels are.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "scenes/scene.h"
#include "view/app.h"

namespace epode::view {
namespace {

struct Size {
    int width, height;
};

class ViewFraming : public testing::Test {
  protected:
    ViewFraming()
    {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        unsigned char* pixels;
        int width, height;
        ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    ~ViewFraming() override { ImGui::DestroyContext(); }

    static void frame(App& app, Size size)
    {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {float(size.width), float(size.height)};
        io.DeltaTime = 1.0f / 60;
        ImGui::NewFrame();
        app.frame(0, size.width, size.height);
        ImGui::Render();
    }

    // The window's left part that the panels cover.
    static float covered()
    {
        const ImGuiWindow* panels = ImGui::FindWindowByName("Panels");
        return panels && panels->Active ? panels->Pos.x + panels->Size.x : 0;
    }

    static bool moves(const viewer::Color& color)
    {
        return color.r != viewer::kStone.r || color.g != viewer::kStone.g || color.b != viewer::kStone.b;
    }

    struct Extent {
        float low[2] = {1e9f, 1e9f}, high[2] = {-1e9f, -1e9f};
        int count = 0, covered = 0;  // of all; of those that a panel or the window's edge hides
    };
    static void add(const App& app, Size size, const float (&pos)[3], Extent& extent)
    {
        float pixel[2] = {-1e9f, -1e9f};
        viewer::project(app.picture().camera, size.width, size.height, pos, pixel);
        extent.covered += !(pixel[0] > covered() && pixel[0] < float(size.width) &&
                            pixel[1] > ImGui::GetFrameHeight() && pixel[1] < float(size.height));
        for (int k = 0; k < 2; ++k) {
            extent.low[k] = std::min(extent.low[k], pixel[k]);
            extent.high[k] = std::max(extent.high[k], pixel[k]);
        }
        ++extent.count;
    }
    // Of shapes by their centres, and of what is drawn as triangles by theirs.
    static Extent extent(const App& app, Size size)
    {
        Extent extent;
        for (const viewer::Shape& shape : app.picture().shapes)
            if (moves(shape.color)) add(app, size, shape.pos, extent);
        for (const viewer::Triangle& triangle : app.picture().triangles) {
            if (!moves(triangle.color)) continue;
            float centre[3] = {0, 0, 0};
            for (int k = 0; k < 3; ++k)
                for (const viewer::Corner& corner : triangle.corners) centre[k] += corner.pos[k] / 3;
            add(app, size, centre, extent);
        }
        return extent;
    }

    static void expect_framed(const App& app, Size size)
    {
        const Extent seen = extent(app, size);
        ASSERT_GT(seen.count, 0);
        EXPECT_LE(seen.covered, seen.count / 50) << "of " << seen.count;
    }

    static constexpr Size kSizes[] = {{800, 600},  {1280, 800}, {1600, 500},
                                      {500, 1000}, {400, 300},  {2560, 1440}};
    scenes::Runtime runtime_;
};

TEST_F(ViewFraming, every_scene_is_next_to_the_panels)
{
    for (const scenes::Recipe* recipe : scenes::all_recipes()) {
        SCOPED_TRACE(recipe->name);
        ViewOptions options;
        options.what = recipe->name;
        options.paused = true;
        App app(options, true);
        std::string problem;
        ASSERT_TRUE(app.open(problem)) << problem;
        for (const Size& size : kSizes) {
            SCOPED_TRACE(testing::Message() << size.width << " x " << size.height);
            frame(app, size);
            ASSERT_GT(covered(), 100);
            expect_framed(app, size);
        }
    }
}

TEST_F(ViewFraming, takes_the_whole_window_without_panels_and_looks_at_everything)
{
    ViewOptions options;
    options.what = "ragdolls";
    options.paused = true;
    App app(options, true);
    std::string problem;
    ASSERT_TRUE(app.open(problem)) << problem;
    const Size size{800, 600};
    for (Action view : {Action::kFrame, Action::kPause}) {
        frame(app, size);
        const Extent framed = extent(app, size);
        app.act(Action::kPanels);
        frame(app, size);
        EXPECT_EQ(covered(), 0);
        expect_framed(app, size);
        const Extent whole = extent(app, size);
        EXPECT_GT(whole.high[0] - whole.low[0], 1.5f * (framed.high[0] - framed.low[0]));
        app.act(Action::kPanels);
        app.act(view);
    }
}

// The middle of what is looked at stays where the composition has it: the same picture, only smaller.
TEST_F(ViewFraming, a_smaller_window_shows_the_same_picture)
{
    ViewOptions options;
    options.what = "boxes-1000";
    options.paused = true;
    App app(options, true);
    std::string problem;
    ASSERT_TRUE(app.open(problem)) << problem;
    app.act(Action::kPanels);
    const auto shape_of = [&](Size size) {
        frame(app, size);
        const Extent seen = extent(app, size);
        return (seen.high[0] - seen.low[0]) / (seen.high[1] - seen.low[1]);
    };
    const float wide = shape_of({1280, 800});
    EXPECT_NEAR(shape_of({640, 480}), wide, 0.01f * wide);
    EXPECT_NEAR(shape_of({900, 350}), wide, 0.01f * wide);
    app.act(Action::kPanels);
    EXPECT_NEAR(shape_of({800, 600}), wide, 0.01f * wide);
}

}  // namespace
}  // namespace epode::view
