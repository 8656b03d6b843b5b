// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The end of a step that was made: what is due to every body that took part.
#pragma once

#include "base/arena.h"
#include "step/continuous.h"
#include "tasks/tasks.h"

namespace epode {

struct Space;

// Geoms are marked as moved, unless `continuous` has done so; callbacks, damping; accumulators are emptied.
// Callbacks come in the order of the bodies, on the caller's thread. `managed`: the space whose contacts the
// world manages, or null; its members, as a rule all geoms there are, are marked by all workers.
void finish_bodies(std::span<Body* const> bodies, const Continuous& continuous, Space* managed,
                   const Tasks& tasks, Arena& arena);

}  // namespace epode
