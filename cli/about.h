// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a recording says of a scene's run, so that the same run can be made again.
#pragma once

#include "cli/plan.h"
#include "record/file/recording.h"

namespace epode::cli {

record::Info about(const scenes::Scene& scene, const RunPlan& plan);
// "" where the recording was made in the precision in which this program computes, else the message.
std::string other_precision(const record::Recording& recording);
// The opposite of about(): false and why where the recording does not come from a scene.
bool options_from(const record::Recording& recording, RunOptions& options, std::string& problem);

}  // namespace epode::cli
