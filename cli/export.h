// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A recording as a file of another format, chosen by the name's ending.
#pragma once

#include <string>

#include "record/file/recording.h"

namespace epode::cli {

enum class Format { kUnknown, kRecording, kGlb, kPage, kCsv };
Format format_of(const std::string& path);
// The endings that format_of knows, for messages.
const char* known_endings();
// False and why where it will not work, whatever the recording.
bool can_export(const std::string& path, std::string& problem);
bool export_recording(const record::Recording& recording, const std::string& path, double fps,
                      std::string& problem);

}  // namespace epode::cli
