// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the page needs of a recording: a JSON head and one block of numbers; page/src/recording.js reads them.
#pragma once

#include <string>
#include <vector>

#include "record/file/recording.h"
#include "record/output/columns.h"

namespace epode::record {

struct PageData {
    std::string head;
    std::vector<std::uint8_t> block;
    std::vector<Columns> smooth;  // arrays of the block that the page rearranges
};

PageData make_page_data(const Recording& recording, double fps);

}  // namespace epode::record
