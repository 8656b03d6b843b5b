// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Motion that a scene prescribes: of driven bodies, and of the boxes that only the broad phase looks at.
#pragma once

#include "bench/scenes/scene_data.h"

namespace epode::bench {

struct BodyState {
    Vec pos;
    Turn turn;
    Vec linear, angular;
};

BodyState start_state(const BodyData& body);
// Pose at `time`, and the velocity that leads from there to where it is `dt` later.
BodyState driven(const BodyData& body, double time, double dt);
// On a straight line, thrown back by the walls of the room.
Vec flown(const SceneData& scene, const BodyData& body, double time);

// The numbers of the bodies that are driven.
std::vector<int> driven_bodies(const SceneData& scene);

}  // namespace epode::bench
