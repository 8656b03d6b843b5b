// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The light of a video is the viewer's quick one, without the sky's shadows: some half a second for a picture
// without a graphics card. A scene without a view of its own keeps that of its first picture, or the camera
// would tremble with whatever moves.
#include "cli/video.h"

#include <fmt/format.h>

#include "cli/film.h"
#include "cli/picture.h"

#ifdef EPODE_HAVE_DRAWING

#include "viewer/headless.h"
#include "viewer/picture.h"
#include "viewer/renderer.h"

namespace epode::cli {

namespace {

constexpr int kWidth = 1280, kHeight = 720;
constexpr viewer::Quality kVideoQuality = viewer::kQuick;

}  // namespace

struct Video::Studio {
    viewer::Headless context;
    viewer::Renderer renderer;
    viewer::Camera camera;
    Film film;
    std::vector<std::uint8_t> rgb;
    double fps = 30;
    int pictures = 0;
    std::string path;
};

bool Video::possible() { return true; }

bool Video::open(const std::string& path, double fps, const scenes::Scene& scene)
{
    studio_ = std::make_unique<Studio>();
    studio_->fps = fps;
    studio_->path = path;
    if (!studio_->context.open(problem_) || !studio_->renderer.open(problem_)) return false;
    viewer::Picture picture;
    draw_scene(scene, picture);
    studio_->camera = picture.camera;
    studio_->film.open(path, kWidth, kHeight, fps);
    return step(scene);
}

bool Video::step(const scenes::Scene& scene)
{
    if (!studio_ || !problem_.empty()) return problem_.empty();
    bool drawn = false;
    // Half a step's rounding must not cost a picture.
    while (scene.time() + 1e-9 >= studio_->pictures / studio_->fps) {
        if (!drawn) {
            viewer::Picture picture;
            picture.width = kWidth;
            picture.height = kHeight;
            picture.quality = kVideoQuality;
            draw_scene(scene, picture);
            if (!scene.view.set) picture.camera = studio_->camera;
            if (!studio_->renderer.draw(picture, problem_) || !studio_->renderer.read(studio_->rgb, problem_))
                return false;
            drawn = true;
        }
        if (!studio_->film.add(studio_->rgb)) {
            problem_ = studio_->film.problem();
            return false;
        }
        ++studio_->pictures;
    }
    return true;
}

bool Video::close()
{
    if (studio_ && !studio_->film.close() && problem_.empty()) problem_ = studio_->film.problem();
    return problem_.empty();
}

std::string Video::remark() const
{
    if (!studio_ || studio_->film.first_png().empty()) return {};
    return fmt::format("there is no ffmpeg, so instead of '{}' there are {} pictures, '{}' and on",
                       studio_->path, studio_->pictures, studio_->film.first_png());
}

Video::Video() = default;
Video::~Video() = default;

}  // namespace epode::cli

#else

namespace epode::cli {

struct Video::Studio {};
Video::Video() = default;
Video::~Video() = default;
bool Video::possible() { return false; }
bool Video::open(const std::string&, double, const scenes::Scene&) { return false; }
bool Video::step(const scenes::Scene&) { return true; }
bool Video::close() { return true; }
std::string Video::remark() const { return {}; }

}  // namespace epode::cli

#endif
