// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// `epode replay` of what `epode capture` recorded.
#pragma once

#include "cli/replay.h"
#include "record/file/recording.h"

namespace epode::cli {

int rerun(const ReplayOptions& options, const record::Recording& was);

}  // namespace epode::cli
