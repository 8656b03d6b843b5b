// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A small recording with one of everything, and its bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "record/file/recording.h"

namespace epode::record {

Recording sample_recording();
std::vector<std::uint8_t> bytes_of(const Recording& recording);
// A path in the test's own folder, which goes with the test program.
std::string scratch(const std::string& name);
std::vector<std::uint8_t> read_all(const std::string& path);

}  // namespace epode::record
