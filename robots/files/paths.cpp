// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See disk.h: paths as text.
#include "robots/files/disk.h"

namespace epode::robots {

std::string folder_of(const std::string& path)
{
    const size_t slash = path.rfind('/');
    if (slash == std::string::npos) return path.empty() ? "" : ".";
    const size_t end = path.find_last_not_of('/', slash);
    return end == std::string::npos ? "/" : path.substr(0, end + 1);
}

std::string name_of(const std::string& path)
{
    const size_t slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

// A dot at the beginning of a name begins no ending.
std::string stem_of(const std::string& path)
{
    const std::string name = name_of(path);
    const size_t dot = name.rfind('.');
    return dot == std::string::npos || dot == 0 || name == ".." ? name : name.substr(0, dot);
}

std::string ending_of(const std::string& path)
{
    const std::string name = name_of(path), stem = stem_of(path);
    std::string ending = stem.size() < name.size() ? name.substr(stem.size() + 1) : "";
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return ending;
}

}  // namespace epode::robots
