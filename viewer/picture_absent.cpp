// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// write_png where epoxy, EGL's headers or stb were missing when the library was configured: programs link and
// run, and report why they get no picture. Cameras and palette do not depend on OpenGL and stay as they
// are.
#include "picture.h"

namespace epode::viewer {

bool write_png(const Picture&, const char*, std::string& error)
{
    error =
        "no picture: built without epoxy/EGL (Debian: apt-get install libepoxy-dev libegl-dev libstb-dev, "
        "then configure again)";
    return false;
}

}  // namespace epode::viewer
