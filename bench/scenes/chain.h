// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A chain of capsules 1 m apart, level at the start, hung from the world by its first ball joint; its links
// do not touch. The last one may weigh more.
#pragma once

#include "bench/scenes/words.h"

namespace epode::bench {

void add_chain(SceneData& scene, int joints, double last_mass);

}  // namespace epode::bench
