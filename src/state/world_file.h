// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The header of a file of a world, checked before anything else is read. Files of one version are read by all
// later libraries; a part that changes gets another version and is read in both ways.
//   1 -> 2   checksum, and what format 4 of states has changed
//   2 -> 3   the budget of hybrid steps (state/object_structure.cpp)
//   3 -> 4   characters (collide/character.cpp)
//   4 -> 5   fluids (state/world_structure.cpp), vehicles (dynamics/forces/vehicle.cpp)
//   5 -> 6   friction axes and materials of faces (state/object_structure.cpp)
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/config.h"

namespace epode {

struct WorldFileHeader {
    static constexpr std::uint32_t kMagic = 0x77736e65;  // "ensw"
    static constexpr std::uint16_t kVersion = 6;

    std::uint32_t magic = kMagic;
    std::uint16_t version = kVersion;
    std::uint16_t real_size = sizeof(Real);
    std::uint64_t structure_size = 0;
    std::uint64_t state_size = 0;
    std::uint64_t checksum = 0;  // of all bytes after this field
};
static_assert(sizeof(WorldFileHeader) == 32);

// Writes the header before a structure that ends at `structure_end` and the state that follows it.
void seal_file(std::span<std::byte> file, std::size_t structure_end);

// Null: valid, and `header` is its header; else the first fault, in words. Bytes behind its end are ignored.
const char* read_file_header(std::span<const std::byte> file, WorldFileHeader& header, char* text,
                             std::size_t text_size);

}  // namespace epode
