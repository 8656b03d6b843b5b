// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the files of a captured program are called: its first world has the name that was asked for, further
// ones get -2, -3 ... before the ending.
#pragma once

#include <string>

namespace epode::record {

inline std::string numbered_path(std::string path, int number)
{
    if (number == 1) return path;
    const size_t dot = path.rfind('.'), slash = path.rfind('/');
    const bool no_ending = dot == std::string::npos || (slash != std::string::npos && dot < slash);
    return path.insert(no_ending ? path.size() : dot, std::string("-").append(std::to_string(number)));
}

}  // namespace epode::record
