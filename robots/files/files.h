// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The files that a reader may open: those in its roots. Roots are the folder of the first file, that folder's parent
// (models lie in urdf/ or xml/ with meshes/ alongside), the ROS package around it, packages found by package://,
// and folders that the caller names. Paths are compared after links and ".." are resolved.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robots/files/disk.h"

namespace epode::robots {

class Files {
  public:
    static constexpr size_t kMaxFile = size_t(256) << 20, kMaxTotal = size_t(1) << 30;

    // The first file's own path, and more roots; package:// looks in these first.
    Files(const std::string& path, std::vector<std::string> roots);

    // The path that a reference in a file of the folder means, "" and a problem where there is none: relative,
    // absolute, file:// and package://.
    std::string resolve(const std::string& reference, const std::string& folder, std::string& problem);
    // A whole file. Nothing and a problem: not in the roots, not a file, too large.
    std::optional<std::string> read(const std::string& path, std::string& problem);

  private:
    bool is_allowed(const std::string& path) const;
    std::string find_package(const std::string& rest, const std::string& folder, std::string& tried);
    std::string in_package(const std::string& root, const std::string& inner, std::string& tried) const;

    std::vector<std::string> named_, roots_;
    std::map<std::string, std::string> packages_;  // found before, with their folders
    size_t total_ = 0;
};

}  // namespace epode::robots
