// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The samples of a height field from files: PNG, whose first channel in eight bits is the height and whose rows run down from the largest y, and MuJoCo's own
// format: two ints (rows, columns), then floats, row by row from the least y. (MuJoCo's documentation, XML Reference, "hfield".)
#pragma once

#include "robots/model.h"

namespace epode::robots {

constexpr size_t kMaxSamples = size_t(4096) * 4096;

// Whether rows and columns are at least 2 and their product no more than kMaxSamples; else a problem.
bool are_good_counts(double rows, double columns, std::string& problem);
// False and a problem: broken bytes, a size that is none, numbers that are not finite.
bool read_heights(const std::string& bytes, bool is_png, HeightField& field, std::string& problem);
bool read_png(const std::string& bytes, HeightField& field, std::string& problem);
// Scaled and moved to 0 ... 1; all equal: 0.
void normalise(std::vector<double>& samples);
// Rows in the other order.
void turn_over(HeightField& field);

}  // namespace epode::robots
