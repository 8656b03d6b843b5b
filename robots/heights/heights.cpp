// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See heights.h.
#include "robots/heights/heights.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "robots/numbers.h"

namespace epode::robots {

namespace {

constexpr size_t kHead = 8;

template <class Number>
Number number_at(const std::string& bytes, size_t at)
{
    Number out;
    std::memcpy(&out, bytes.data() + at, sizeof out);
    return out;
}

bool read_binary(const std::string& bytes, HeightField& field, std::string& problem)
{
    if (bytes.size() < kHead) return problem = "is too short to have a number of rows and columns", false;
    const auto rows = number_at<std::int32_t>(bytes, 0), columns = number_at<std::int32_t>(bytes, 4);
    if (!are_good_counts(rows, columns, problem)) return false;
    const size_t count = size_t(rows) * size_t(columns), wanted = kHead + 4 * count;
    if (bytes.size() != wanted) {
        problem = "has " + std::to_string(bytes.size()) + " bytes; its " + std::to_string(rows) +
                  " rows of " + std::to_string(columns) + " samples take " + std::to_string(wanted);
        return false;
    }
    field.rows = rows, field.columns = columns;
    field.samples.resize(count);
    for (size_t i = 0; i < count; ++i) {
        field.samples[i] = double(number_at<float>(bytes, kHead + 4 * i));
        if (!std::isfinite(field.samples[i])) return problem = "has a sample that is not finite", false;
    }
    return true;
}

}  // namespace

bool are_good_counts(double rows, double columns, std::string& problem)
{
    const auto is_count = [](double value) { return value >= 2 && value == std::floor(value); };
    if (is_count(rows) && is_count(columns) && rows * columns <= double(kMaxSamples)) return true;
    problem = "has " + text_of(rows) + " rows of " + text_of(columns) +
              " samples; wanted 2 or more of each, and at most " + std::to_string(kMaxSamples) + " in all";
    return false;
}

void normalise(std::vector<double>& samples)
{
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    const double least = *low, span = *high - *low;
    for (double& value : samples) value = span > 0 ? (value - least) / span : 0;
}

void turn_over(HeightField& field)
{
    const auto row = [&](int number) { return field.samples.begin() + long(number) * field.columns; };
    for (int i = 0; i < field.rows / 2; ++i) std::swap_ranges(row(i), row(i + 1), row(field.rows - 1 - i));
}

bool read_heights(const std::string& bytes, bool is_png, HeightField& field, std::string& problem)
{
    if (!(is_png ? read_png : read_binary)(bytes, field, problem)) return false;
    normalise(field.samples);
    return true;
}

}  // namespace epode::robots
