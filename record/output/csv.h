// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The states of a recording as a table for any plotting program: one line per step and body.
#pragma once

#include "record/file/recording.h"

namespace epode::record {

bool write_csv(const Recording& recording, const std::string& path, std::string& problem);

}  // namespace epode::record
