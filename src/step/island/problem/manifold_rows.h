// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Manifolds for solvers that want rows: what contact joints with the same coefficients would write. Friction
// is bounded in two directions then, since rows know no discs.
#pragma once

#include "step/island/problem/assemble.h"

namespace epode {

// Gives the manifolds of the island their bodies' places.
void place_manifolds(const Tasks& tasks, const Island& island);
int manifold_row_count(const Island& island);
int manifold_point_count(const Island& island);
// Appends rows and blocks after the first `rows` and `blocks` of work.system, whose capacity suffices. `cone`:
// friction is bounded by an ellipse, not by a box.
void emit_manifolds(const StepInfo& info, bool cone, IslandWork& work, int& rows, int& blocks);
// Numbers must hold the rows' own by now.
void load_manifold_impulses(IslandWork& work, Real share);
// `times`: what the impulses of the whole step are of those of the system's.
void store_manifold_impulses(const IslandWork& work, Real times);

}  // namespace epode
