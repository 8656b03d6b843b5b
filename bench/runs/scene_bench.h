// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Times one scene: the same steps, repeated from a fresh start, split into collide, step and empty, with the
// quality next to the time, since a fast wrong answer is no answer.
#pragma once

#include <cstdint>
#include <string>

#include "scenes/scene.h"

namespace epode::bench {

struct SceneOptions {
    std::string scene;
    std::string stepper;  // empty: the scene's own
    double dt = 0;        // 0: the scene's own
    int steps = 0;        // 0: the scene's own seconds
    int repeat = 3;
    int iterations = 0;
    std::uint32_t seed = 1;
    bool json = false;
};

// 0 fine, 1 a state that is not finite or a failed step, 2 wrong usage.
int bench_scene(const SceneOptions& options);

}  // namespace epode::bench
