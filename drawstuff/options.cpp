// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Flags are drawstuff's own; unknown ones belong to the program. The variables EPODE_... are described in
// drawstuff.h; like MuJoCo's MUJOCO_GL, EPODE_GL says by what pictures are made.
#include "options.h"

#include <charconv>
#include <cstdlib>
#include <cstring>

#include "messages.h"

namespace epode::drawstuff {

namespace {

bool is_set(const char* name)
{
    const char* value = secure_getenv(name);
    return value && *value;
}

void read_number(const char* name, int least, int& number)
{
    const char* text = secure_getenv(name);
    if (!text) return;
    int value = 0;
    const char* end = text + std::strlen(text);
    const auto [stop, error] = std::from_chars(text, end, value);
    if (error == std::errc{} && stop == end && value >= least) {
        number = value;
    } else {
        note("%s=%s is not a number from %d on and is not used", name, text, least);
    }
}

void read_flags(int argc, const char* const* argv, Options& options)
{
    for (int i = 1; i < argc && argv && argv[i]; ++i) {
        const std::string flag = argv[i];
        if (flag == "-notex") options.textures = false;
        if (flag == "-noshadow" || flag == "-noshadows") options.shadows = false;
        if (flag == "-pause") options.paused = true;
        if (flag == "-texturepath" && i + 1 < argc && argv[i + 1]) options.texture_path = argv[++i];
    }
}

void read_surroundings(Options& options)
{
    options.headless = !is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY");
    if (is_set("EPODE_GL")) {
        const std::string gl = secure_getenv("EPODE_GL");
        if (gl == "egl" || gl == "window") {
            options.headless = gl == "egl";
        } else {
            note("EPODE_GL=%s is neither egl nor window and is not used", gl.c_str());
        }
    }
    if (const char* folder = secure_getenv("EPODE_FRAMES")) options.frame_folder = folder;
    read_number("EPODE_FRAME_COUNT", 0, options.frame_count);
    read_number("EPODE_FRAME_EVERY", 1, options.frame_every);
    options.fine = is_set("EPODE_LOOK") && std::strcmp(secure_getenv("EPODE_LOOK"), "fine") == 0;
}

}  // namespace

Options read_options(int argc, const char* const* argv, const dsFunctions& functions)
{
    Options options;
    if (functions.version >= 2 && functions.path_to_textures)
        options.texture_path = functions.path_to_textures;
    read_flags(argc, argv, options);
    read_surroundings(options);
    return options;
}

}  // namespace epode::drawstuff
