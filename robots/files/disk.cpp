// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See disk.h: the files of the system.
#include "robots/files/disk.h"

#include <filesystem>
#include <fstream>

namespace epode::robots {

namespace fs = std::filesystem;

std::string canonical(const std::string& path)
{
    if (path.empty() || path.size() > 4096 || path.find('\0') != std::string::npos) return {};
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? std::string() : whole.string();
}

bool is_file(const std::string& path)
{
    std::error_code error;
    return !path.empty() && fs::is_regular_file(path, error);
}

std::optional<std::uintmax_t> size_of_file(const std::string& path)
{
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    return error ? std::nullopt : std::optional(size);
}

bool read_file(const std::string& path, std::string& text)
{
    std::ifstream file(path, std::ios::binary);
    return bool(file.read(text.data(), std::streamsize(text.size())));
}

}  // namespace epode::robots
