// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What programs ask of spaces, for each kind of space, as bench/collide --table has it.
#pragma once

namespace epode::bench {

// Prints lines `SPACE QUERY NS COUNT`: the least time of one query, and how many pairs or hits all of
// them had, by which two libraries are seen to have answered alike.
int bench_space_table();

}  // namespace epode::bench
