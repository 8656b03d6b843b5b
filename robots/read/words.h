// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sets of words, and which of them a wrong one was meant to be.
#pragma once

#include <set>
#include <string>

namespace epode::robots {

using Words = std::set<std::string>;

// The words of a text, parted by blanks.
Words words_of(const std::string& text);
// "; did you mean 'X'?" of the nearest word, or nothing where none is near.
std::string advice(const std::string& wrong, const Words& words);

}  // namespace epode::robots
