// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds in files (ode/world_file.h): a scene that is saved, and what can be done with a file alone.
#pragma once

#include <string>

#include "cli/plan.h"

namespace epode::cli {

bool is_world_file(const std::string& name);  // by its ending

// Runs the scene as `epode run` would and saves its world to `path`.
int save_scene(const RunOptions& options, const std::string& path);
// Steps the world of the file that options.scene names.
int run_world_file(const RunOptions& options);
int describe_world_file(const std::string& path, bool json);

}  // namespace epode::cli
