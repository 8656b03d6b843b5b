// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The header of every state, checked before anything else is read: format, size, and a checksum of its bytes.
// Sizes of both kinds, whole states and differences between two (state/delta.h), are multiples of four bytes.
// The version must change whenever a part of the engine writes something else; those from kOldest on are
// still read: files of worlds have them (tests/state/version_test.cpp).
//   3 -> 4   contact manifolds (contacts/state/contact_format.h), the seed of dRand (state/world_state.h),
//            checksum
//   4 -> 5   manifolds that were struck (contacts/state/contact_format.h)
//   5 -> 6   turns of angles with the stops (joints/limit_motor.cpp), no longer with the drives; manifolds at
//            borders (contacts/state/contact_format.h); mean forces of joints, and the step sizes that impulses
//            belong to (dynamics/joint_state.cpp, step/common/contact_cache_state.cpp, contact_format.h)
//   6 -> 7   softness of joints that equals the world's, which may be another when the state is loaded (joints/parts.cpp)
//   7 -> 8   what is left of idle steps and time where it equals the body's settings (dynamics/body_state.cpp)
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/config.h"

namespace epode {

struct StateHeader {
    static constexpr std::uint32_t kMagic = 0x74736e65;  // "enst"
    static constexpr std::uint16_t kVersion = 8, kOldest = 3;
    enum Kind : std::uint8_t { kWhole = 1, kDelta = 2 };

    std::uint32_t magic = kMagic;
    std::uint16_t version = kVersion;
    std::uint8_t real_size = sizeof(Real);
    std::uint8_t kind = kWhole;
    std::uint64_t size = 0;      // bytes, with the header
    std::uint64_t checksum = 0;  // of all bytes after this field
};
static_assert(sizeof(StateHeader) == 24);

// The header whose bytes in memory are those of a state, and the other way round.
StateHeader little(StateHeader header);

// kUnsealed: without a checksum, for bytes that never leave the library.
enum class Seal : std::uint8_t { kSealed, kUnsealed };

// Writes the header of a state whose other bytes have been written.
void seal(void* state, std::size_t size, StateHeader::Kind kind, Seal with = Seal::kSealed);

// Writes a whole state without a seal to `to`, sealed.
void copy_sealed(void* to, std::span<const std::byte> state);

// Null: valid, and `header` is its header; else the first fault, in words. Bytes after the state's end are
// ignored.
const char* read_header(const void* state, std::size_t size, StateHeader::Kind kind, StateHeader& header,
                        char* text, std::size_t text_size, Seal with = Seal::kSealed);

}  // namespace epode
