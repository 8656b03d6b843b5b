// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See columns.h.
#include "record/output/columns.h"

namespace epode::record {

namespace {

// 0, -1, 1, -2 ... as 0, 1, 2, 3 ...
std::uint16_t folded(std::uint16_t difference)
{
    const auto sign = std::uint16_t(difference >> 15 ? 0xffff : 0);
    return std::uint16_t(std::uint16_t(difference << 1) ^ sign);
}

}  // namespace

void rearrange(std::vector<std::uint8_t>& bytes, const Columns& columns)
{
    const size_t rows = columns.width ? columns.values / columns.width : 0;
    const auto value = [&](size_t row, size_t column) {
        const size_t at = columns.offset + 2 * (row * columns.width + column);
        return std::uint16_t(bytes[at] | bytes[at + 1] << 8);
    };
    std::vector<std::uint8_t> low, high;
    for (size_t column = 0; column < columns.width; ++column) {
        std::uint16_t one = 0, two = 0;  // the row before, and the one before that
        for (size_t row = 0; row < rows; ++row) {
            const std::uint16_t now = value(row, column), left = folded(std::uint16_t(now - 2 * one + two));
            low.push_back(std::uint8_t(left & 255));
            high.push_back(std::uint8_t(left >> 8));
            two = one;
            one = now;
        }
    }
    auto out = bytes.begin() + std::ptrdiff_t(columns.offset);
    for (const auto* part : {&low, &high})
        for (std::uint8_t byte : *part) *out++ = byte;
}

}  // namespace epode::record
