// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene as JSON, for engines outside this program (bench/peers), with the names of scene_data.h.
#pragma once

#include "bench/scenes/scene_data.h"

namespace epode::bench {

std::string to_json(const SceneData& scene);

}  // namespace epode::bench
