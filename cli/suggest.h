// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What somebody may have meant who mistyped a name: the nearest of those there are.
#pragma once

#include <string>
#include <vector>

namespace epode::cli {

// Damerau and Levenshtein: insertions, deletions, substitutions and exchanges of neighbours.
int edit_distance(const std::string& a, const std::string& b);
// "" where nothing is near: more than a third of the letters differ, and the word begins none of the names.
std::string nearest(const std::string& word, const std::vector<std::string>& names);
// " Did you mean 'NAME'?", or "".
std::string did_you_mean(const std::string& word, const std::vector<std::string>& names);

}  // namespace epode::cli
