// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Reads a recording and believes nothing: every chunk's checksum, every count, every number of an object and
// every size is checked before it goes to the sink, so that whoever listens may index freely. A file that
// is broken or breaks off is refused with the place and the reason.
#pragma once

#include "record/file/recording.h"

namespace epode::record {

enum class Damage {
    kNone,
    kUnreadable,  // no such file, or not a recording of a version that is known
    kBreaksOff,  // whole up to a place and then nothing: the recorded program died; what was read can be used
    kBroken      // changed somewhere: what was read before the place is sound
};

struct ReadResult {
    Damage damage = Damage::kNone;
    std::string problem;
    bool whole() const { return damage == Damage::kNone; }
};

ReadResult read_bytes(const std::uint8_t* bytes, size_t size, Sink& sink);
ReadResult read_file(const std::string& path, Sink& sink);

}  // namespace epode::record
