// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// `epode view`: the command line of view/view.h, there even where the viewer itself was not built: it then
// says what is missing.
#pragma once

#include <CLI/CLI.hpp>

#include "view/view.h"

namespace epode::cli {

void add_view_options(CLI::App& command, view::ViewOptions& options);
int view(const view::ViewOptions& options);

}  // namespace epode::cli
