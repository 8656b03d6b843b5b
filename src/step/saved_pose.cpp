// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The rotation is kept beside the quaternion: made anew from it, it could differ in the last place.
#include "step/saved_pose.h"

#include <algorithm>

namespace epode {

std::span<SavedPose> save_poses(const Island& island, Arena& arena)
{
    auto saved = arena.take<SavedPose>(int(island.bodies.size()));
    for (std::size_t i = 0; i < saved.size(); ++i) {
        const Body& b = *island.bodies[i];
        std::copy(b.pos, b.pos + 4, saved[i].pos);
        std::copy(b.q, b.q + 4, saved[i].q);
        std::copy(b.R, b.R + 12, saved[i].R);
    }
    return saved;
}

void restore_poses(const Island& island, std::span<const SavedPose> saved)
{
    for (std::size_t i = 0; i < saved.size(); ++i) {
        Body& b = *island.bodies[i];
        std::copy(saved[i].pos, saved[i].pos + 4, b.pos);
        std::copy(saved[i].q, saved[i].q + 4, b.q);
        std::copy(saved[i].R, saved[i].R + 12, b.R);
    }
}

}  // namespace epode
