// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Whether a file can be written, asked before the work that it is to hold is done.
#pragma once

#include <string>

namespace epode::cli {

// False and why: no such folder, a folder itself, no right to write. Neither creates nor changes anything.
bool can_write(const std::string& path, std::string& problem);

}  // namespace epode::cli
