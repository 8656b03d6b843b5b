// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A decimal number of a text, with a point in every locale.
#pragma once

namespace epode::robots {

// Reads the number that begins at `at` as std::from_chars does: no blank and no "+" before it. Returns its end, null where there is
// none or it is beyond what a double can be.
const char* read_number(const char* at, const char* end, double& value);

}  // namespace epode::robots
