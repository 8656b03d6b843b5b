// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What two recordings have in common, as a report: the first step and body in which they differ, and how far
// apart they go.
#pragma once

#include "cli/fields.h"
#include "record/file/recording.h"

namespace epode::cli {

// Prints the fields; the exit code.
int report(FieldList& out, bool json, bool fine);
// A difference is a problem, unless only_distances says that one is expected.
int compare(const record::Recording& a, const record::Recording& b, bool only_distances, FieldList& out,
            bool json);

}  // namespace epode::cli
