// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See suggest.h. The table of distances between all beginnings of the two words (the "optimal string
// alignment" form: no piece is edited twice).
#include "cli/suggest.h"

#include <algorithm>

namespace epode::cli {

namespace {

// Nobody mistypes a word this long; the table stays small.
constexpr size_t kLongest = 64;

}  // namespace

int edit_distance(const std::string& a, const std::string& b)
{
    std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
    for (size_t i = 0; i <= a.size(); ++i) d[i][0] = int(i);
    for (size_t j = 0; j <= b.size(); ++j) d[0][j] = int(j);
    for (size_t i = 1; i <= a.size(); ++i) {
        for (size_t j = 1; j <= b.size(); ++j) {
            d[i][j] = std::min(
                {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

std::string nearest(const std::string& word, const std::vector<std::string>& names)
{
    if (word.empty() || word.size() > kLongest) return {};
    std::string best;
    int least = 1 + std::max(1, int(word.size()) / 3);
    for (const std::string& name : names) {
        const int distance = edit_distance(word, name);
        if (distance < least) least = distance, best = name;
    }
    if (!best.empty() || word.size() < 3) return best;
    const auto begun =
        std::find_if(names.begin(), names.end(), [&](const std::string& n) { return n.starts_with(word); });
    return begun == names.end() ? std::string() : *begun;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names)
{
    const std::string name = nearest(word, names);
    return name.empty() ? name : " Did you mean '" + name + "'?";
}

}  // namespace epode::cli
