// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// same_picture A B SHARE: exit status 0 if both are pictures of one size and at most that share of their pixels differs by more than a
// shade, as drivers do: 16 of 255 in a colour.
#include <cstdio>
#include <cstdlib>

#include "png_reader.h"

namespace {

constexpr int kShade = 16;

double share_of_different(const Image& a, const Image& b)
{
    size_t different = 0;
    for (size_t at = 0; at < a.rgb.size(); at += 3) {
        bool differs = false;
        for (size_t i = at; i < at + 3; ++i) differs = differs || std::abs(a.rgb[i] - b.rgb[i]) > kShade;
        different += differs;
    }
    return double(different) / double(a.rgb.size() / 3);
}

}  // namespace

int main(int count, char** words)
{
    if (count != 4) return std::fprintf(stderr, "usage: same_picture A B SHARE\n"), 2;
    const Image a = read_png(words[1]), b = read_png(words[2]);
    if (a.rgb.empty() || a.width != b.width || a.height != b.height) {
        std::printf("%d x %d and %d x %d pixels\n", a.width, a.height, b.width, b.height);
        return 1;
    }
    const double share = share_of_different(a, b);
    std::printf("%.3g %% of the pixels differ\n", 100 * share);
    return share <= std::atof(words[3]) ? 0 : 1;
}
