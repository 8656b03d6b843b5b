// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a world keeps of its states from call to call: the lists that saving fills, and its history.
#pragma once

#include "state/history.h"
#include "state/world_state.h"

namespace epode {

struct WorldArchive : StepObserver {
    explicit WorldArchive(World& world) : state(world), history(world, state) {}
    WorldState state;
    History history;
};

// Made if there is none yet; null: out of memory.
WorldArchive* archive_of(World& world);

// Null: there is none.
History* history_of(const World& world);

// Has any world of the process a history?
bool any_history();

// The program destroys an object: true if the history of its world keeps it, false if it must be destroyed.
bool keep_for_history(Body& body);
bool keep_for_history(Joint& joint, dJointGroupID group);
bool keep_for_history(Geom& geom);

}  // namespace epode
