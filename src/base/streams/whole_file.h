// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Files that are read and written as a whole. What is written goes to a new file in the same folder, which
// takes the old one's place when all of it is on the disk: whoever reads sees the old bytes or the new ones.
#pragma once

#include <cstddef>
#include <span>

#include "base/array.h"

namespace epode {

// These return null, or why not, in words.
const char* read_file(const char* path, Array<std::byte>& out, char* text, std::size_t text_size);
const char* write_file(const char* path, std::span<const std::byte> bytes, char* text, std::size_t text_size);

}  // namespace epode
