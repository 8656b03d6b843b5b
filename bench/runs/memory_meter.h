// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a libode takes by its memory handlers: bytes asked for, now and at most. Bookkeeping of the C library
// is not in it. Other engines do not go through these handlers, for them nothing is counted.
#pragma once

#include <cstddef>

namespace epode::bench {

// From here on; for the rest of the process.
void meter_memory();
std::size_t bytes_now();
std::size_t peak_bytes();

}  // namespace epode::bench
