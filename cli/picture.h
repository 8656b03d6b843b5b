// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene as a picture file. The only place of the program that knows both the public C API and the viewer.
#pragma once

#include <string>

#include "scenes/scene.h"

namespace epode::viewer {
struct Picture;
}

namespace epode::cli {

// False in a build without the viewer.
bool can_draw();
// What the scene looks like now. Only in a build with the viewer.
void draw_scene(const scenes::Scene& scene, viewer::Picture& picture);
bool save_picture(const scenes::Scene& scene, const std::string& path, std::string& problem);

}  // namespace epode::cli
