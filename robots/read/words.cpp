// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See words.h.
#include "robots/read/words.h"

#include <algorithm>
#include <vector>

namespace epode::robots {

namespace {

// How many letters must be changed, added or left out.
size_t distance(const std::string& a, const std::string& b)
{
    std::vector<size_t> row(b.size() + 1);
    for (size_t k = 0; k <= b.size(); ++k) row[k] = k;
    for (size_t i = 1; i <= a.size(); ++i) {
        size_t before = row[0];
        row[0] = i;
        for (size_t k = 1; k <= b.size(); ++k) {
            const size_t changed = before + (a[i - 1] != b[k - 1]);
            before = row[k];
            row[k] = std::min({changed, row[k] + 1, row[k - 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

Words words_of(const std::string& text)
{
    Words out;
    size_t begin = 0;
    while (begin < text.size()) {
        const size_t end = std::min(text.find(' ', begin), text.size());
        if (end > begin) out.insert(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

// Long words, and more than there are names in any file that a person writes, take time that nobody waits for.
std::string advice(const std::string& wrong, const Words& words)
{
    constexpr size_t kLongest = 60, kMaxWords = 2000;
    std::string best;
    size_t least = wrong.size() / 2 + 1;
    if (wrong.size() <= kLongest && words.size() <= kMaxWords)
        for (const std::string& word : words)
            if (const size_t its = word.size() <= kLongest ? distance(wrong, word) : least; its < least)
                least = its, best = word;
    return best.empty() ? "" : "; did you mean '" + best + "'?";
}

}  // namespace epode::robots
