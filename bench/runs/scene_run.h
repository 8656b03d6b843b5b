// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One run of one engine on one benchmark scene: its time step by step and the quality of what came out.
// bench/compare and bench/peers call it again and again.
#pragma once

#include "bench/engines/engine.h"
#include "bench/scenes/recipe.h"

namespace epode::bench {

struct SceneRunOptions {
    SceneChoice scene;
    EngineOptions engine;
    std::string engine_name = "ode";
    bool judged = true;
    bool memory = false;  // bytes of the scene, and what its steps take on top
};

// Prints JSON. 0 fine, 1 a state that is not finite, 2 no such scene or engine, 3 the engine cannot.
int run_scene(const SceneRunOptions& options);

// Prints the scenes with their settings as JSON lines.
int list_scenes();
// Prints the scene as JSON.
int export_scene(const SceneChoice& choice);
// Judges states that an engine outside has written: lines "state STEP" followed by a line of 13 numbers a
// body, position, quaternion, linear and angular velocity. Prints JSON as run_scene does.
int judge_file(const SceneChoice& choice, const std::string& path);

}  // namespace epode::bench
