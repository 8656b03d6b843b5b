// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every state begins with, and what is checked before anything else is believed: who wrote it, how long
// it is, and whether its bytes are still what they were. Both kinds, whole states and differences between two
// (state/delta.h), are multiples of four bytes. The format belongs to the version: a change of what parts of
// the engine write makes it another one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/config.h"

namespace epode {

struct StateHeader {
    static constexpr std::uint32_t kMagic = 0x74736e65;  // "enst"
    static constexpr std::uint16_t kVersion = 1;
    enum Kind : std::uint8_t { kWhole = 1, kDelta = 2 };

    std::uint32_t magic = kMagic;
    std::uint16_t version = kVersion;
    std::uint8_t real_size = sizeof(Real);
    std::uint8_t kind = kWhole;
    std::uint64_t size = 0;      // bytes, with the header
    std::uint64_t checksum = 0;  // of all bytes behind this number
};
static_assert(sizeof(StateHeader) == 24);

// Fills in size and checksum of a state that has been written behind the header's place.
void seal(void* state, std::size_t size, StateHeader::Kind kind);

// Null: sound, and `header` is its header; else, in words, the first thing that is wrong. Bytes behind its
// end are not looked at.
const char* read_header(const void* state, std::size_t size, StateHeader::Kind kind, StateHeader& header,
                        char* text, std::size_t text_size);

}  // namespace epode
