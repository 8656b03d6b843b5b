// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a diagnosed scene has found out about itself, with bodies by their numbers.
#pragma once

#include <cstdint>

#include "scenes/scene.h"

namespace epode::scenes {

struct Cause {
    int severity = 0;        // 0: a note, 1: a warning, 2: an error
    std::int32_t body = -1;  // to blame; -1: none
    std::string text;        // with the remedy, and at its end the bodies: "[body 3, body 5]"
};

// The most severe first, at most so many; none where the library does not diagnose.
std::vector<Cause> causes_of(const Scene& scene, std::size_t max_count);

}  // namespace epode::scenes
