// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where GLFW was missing when the library was configured: there are no windows, frames become files.
#include "surface.h"

namespace epode::drawstuff {

std::unique_ptr<Surface> make_window_surface() { return nullptr; }

}  // namespace epode::drawstuff
