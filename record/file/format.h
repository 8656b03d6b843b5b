// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The frame of a .epr file: an 8-byte mark, a version, and chunks
//     tag (4 letters)   length of the payload (64 bit)   CRC-32 of these two   payload   CRC-32 of all before
// one for each thing that happened, in order; docs/recording.md has the payloads. Every chunk is checked by
// itself (a CRC finds any change within 32 bits in a row for certain), so a file that breaks off is whole up
// to its last whole chunk; the length is checked before it is believed, so that a broken length is not taken
// for a file that breaks off. The alternative, one table at the end, makes a file of a killed program
// worthless.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epode::record {

constexpr char kMark[8] = {'E', 'P', 'O', 'D', 'E', 'R', 'E', 'C'};
constexpr std::uint32_t kVersion = 2;  // 1 has no CALL, STOP and LIMI; it is read too
constexpr std::uint32_t kOldestVersion = 1;
constexpr size_t kFileHead = 12;   // mark, version
constexpr size_t kChunkHead = 16;  // tag, length, their CRC-32
constexpr size_t kChunkTail = 4;   // CRC-32 of all before

constexpr std::uint32_t tag(const char (&letters)[5])
{
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value |= std::uint32_t(static_cast<unsigned char>(letters[i])) << (8 * i);
    return value;
}

constexpr std::uint32_t kInfoTag = tag("INFO"), kShapeTag = tag("SHAP"), kBodyTag = tag("BODY"),
                        kGeomTag = tag("GEOM"), kJointTag = tag("JOIN"), kGoneTag = tag("GONE"),
                        kMovedTag = tag("MOVE"), kCallTag = tag("CALL"), kStopTag = tag("STOP"),
                        kLimitTag = tag("LIMI"), kStepTag = tag("STEP"), kDoneTag = tag("DONE");

// CRC-32 of IEEE 802.3 (polynomial 0x04C11DB7, reflected), started with `so_far` of the bytes before; 0 for
// none.
std::uint32_t crc32(const std::uint8_t* bytes, size_t count, std::uint32_t so_far = 0);

}  // namespace epode::record
