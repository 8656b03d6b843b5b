// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where the bodies of an island were, so that a step that fails after it has moved them can be undone.
#pragma once

#include "base/arena.h"
#include "dynamics/island.h"

namespace epode {

struct SavedPose {
    Real pos[4], q[4], R[12];
};

// Empty when the arena is exhausted.
std::span<SavedPose> save_poses(const Island& island, Arena& arena);
void restore_poses(const Island& island, std::span<const SavedPose> saved);

}  // namespace epode
