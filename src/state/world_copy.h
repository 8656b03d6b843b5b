// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Copies of worlds (ode/world_file.h): structure (state/world_structure) and then state (state/world_state),
// which checks the structure once more. A clone is made in the process and shares meshes; a file has the
// header of state/world_file.h, and its structure is padded to a multiple of eight bytes.
#pragma once

#include "base/array.h"
#include "collide/space.h"
#include "dynamics/world.h"
#include "ode/world_file.h"

namespace epode {

class WorldStructure;

struct WorldCopy {
    World* world = nullptr;
    Space* space = nullptr;  // the outermost one of its geoms; null: none
};

// Pairs of handles, the original's and the clone's: world, bodies, joints, geoms.
struct HandleTable {
    dHandlePair* pairs = nullptr;
    int capacity = 0;

    void write(const WorldStructure& from, int column) const;
};

// These return null, or what is wrong, with nothing changed. `space`: the outermost one of the geoms, or null.
const char* clone_world(World& world, Space* space, WorldCopy& out, HandleTable table, char* text,
                        std::size_t text_size);
const char* save_world(World& world, Space* space, Array<std::byte>& out, char* text, std::size_t text_size);
const char* load_world(std::span<const std::byte> file, WorldCopy& out, char* text, std::size_t text_size);

// How many pairs the table of a clone has. 0: it cannot be cloned, as `text` says.
int count_handles(World& world, Space* space, char* text, std::size_t text_size);

}  // namespace epode
