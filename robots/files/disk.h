// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What readers ask of the file system, and paths as text. In WebAssembly, which has no files, wasm/robots/held_files.cpp answers from
// those that the page has given.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace epode::robots {

// Absolute, without links, "." and "..". "" for what cannot be a path.
std::string canonical(const std::string& path);
bool is_file(const std::string& path);
// Nothing where there is no such file.
std::optional<std::uintmax_t> size_of_file(const std::string& path);
// As many bytes as the text has, from the file's beginning. False where they cannot be read.
bool read_file(const std::string& path, std::string& text);

// The folder that a path names a file in: "." of a name without one.
std::string folder_of(const std::string& path);
// What follows the last slash, and that without its ending.
std::string name_of(const std::string& path);
std::string stem_of(const std::string& path);
// In lower case, without the dot.
std::string ending_of(const std::string& path);

}  // namespace epode::robots
