// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps islands from forces to poses, whatever it takes: a stepper's attempt that would take too much work is followed by its
// fallback's; an island whose sweeps diverge (island/divergence.h) is stepped again without the impulses of the last step, then
// exactly if it is small, else contained (island/containment.h).
#pragma once

#include "step/island/island_run.h"

namespace epode {

// Of consecutive islands in the arrays of all bodies and joints; more than one only if the stepper shares (steppers/stepper.h).
// False: out of memory; the bodies are then half stepped, and the caller must restore them.
[[nodiscard]] bool step_islands(const StepContext& context, std::span<const Island> islands,
                                IslandPlace place, const Tasks& tasks, Arena& arena,
                                const IslandRecords& records);

}  // namespace epode
