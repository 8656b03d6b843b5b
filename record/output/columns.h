// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers of 16 bits that follow smooth paths, rearranged in their place so that they compress well; the page (src/recording.js) puts
// them back. Of `width` columns each is written as second differences (what is left of a row when it goes on as the two before it), signs
// in the lowest bit, first all low bytes, then all high bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace epode::record {

struct Columns {
    size_t offset = 0, values = 0, width = 0;  // bytes, numbers, numbers a row
};

void rearrange(std::vector<std::uint8_t>& bytes, const Columns& columns);

}  // namespace epode::record
