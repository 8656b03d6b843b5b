// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the values of MJCF's attributes may be: words where they are words, and which attributes an element must have. Tables that
// MuJoCo has answered (tools/mjcf_words.py), so that a slip is refused where it stands instead of being read as something else.
#pragma once

#include <string>
#include <vector>

#include "robots/read/reading.h"
#include "robots/read/words.h"

namespace epode::robots {

// Null where the attribute of that element takes any value.
const Words* keywords_of(const std::string& element, const std::string& attribute);

// Attributes and words of an element, and the data of <custom>, <size> and `user`. `path`: as mjcf_names.h has it.
void check_mjcf_values(const Element& element, const std::string& path, Reading& reading);

}  // namespace epode::robots
