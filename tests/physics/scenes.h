// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Three small scenes for the tests of determinism, threads and memory: a mixed pile, a machine with a joint
// of every kind, a wall hit by a ball. Built without any function of libm, so that the bits are the same
// everywhere.
#pragma once

#include "rig.h"

namespace epode::physics {

enum class Scene { kPile, kMachine, kWall };
inline constexpr Scene kScenes[] = {Scene::kPile, Scene::kMachine, Scene::kWall};
const char* name_of(Scene scene);
int steps_of(Scene scene);  // worth running, at h = 0.01
void build(Sim& sim, Scene scene, std::uint32_t seed = 1);

}  // namespace epode::physics
