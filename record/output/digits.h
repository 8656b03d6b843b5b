// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers in files: with a point in every locale, where printf writes what the program's users write.
#pragma once

#include <charconv>
#include <string>

namespace epode::record {

// As "%.*g" in the C locale.
inline std::string digits_of(double value, int digits)
{
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

}  // namespace epode::record
