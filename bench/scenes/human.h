// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ragdoll of capsules, 1.8 m tall: pelvis, chest, head, two of upper arm, forearm, thigh and shin; ball
// joints at neck, spine, shoulders and hips, hinges with stops at elbows and knees. With hands and feet, 15
// bodies.
#pragma once

#include "bench/scenes/words.h"

namespace epode::bench {

// The shapes of one, made once for all ragdolls of a scene.
struct HumanShapes {
    int trunk, head, arm, leg, end;
};
HumanShapes add_human_shapes(SceneData& scene);

struct HumanPose {
    Vec pos;  // of the pelvis
    Turn turn;
    bool hands_and_feet = false;
    int group = 0;
};
void add_human(SceneData& scene, const HumanShapes& shapes, const HumanPose& pose);

}  // namespace epode::bench
