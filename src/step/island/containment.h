// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An island whose solution is not finite is contained: it keeps its velocities, its constraints exert nothing, and other islands are
// unaffected. One whose sweeps diverge, or whose corrections throw it (divergence.h), is set aside to be solved in another way, if
// there is one.
#pragma once

#include "step/island/island_run.h"

namespace epode {

// Are its velocities such as a program may set?
bool keeps_numbers(const Body& body);

// Of a part, with all that the solution has written.
void contain_part(IslandRun& run, int part);
// The same, to be solved again with this share of its corrections.
void set_part_aside(IslandRun& run, int part, Real correction);
// Whether what corrections throw is looked for: in worlds that bound their speed, as the presets do (dWorldSetContactMaxCorrectingVel). Without a
// bound ERP moves bodies as fast as it asks, as in ODE.
bool bounds_corrections(const IslandRun& run);
// The share of the corrections of a solution that does not throw the island; 1: this one does not, or nothing is left of them.
Real correctable(const IslandRun& run, const IslandWork& work, Real h);
// Where nothing is known of the solution: the whole island keeps its velocities, and its poses advance with them.
void contain_island(IslandRun& run);

// Looks at part after part of a solution; contains what is not finite, and what `may_diverge` and has; sets aside what corrections
// have thrown. Returns whether the part was.
bool contain_if_unsound(IslandRun& run, int part, bool may_diverge);

// f(part, contained) is called for each part.
template <typename Judged>
void contain_unsound(IslandRun& run, bool may_diverge, Judged&& f)
{
    for (int part = 0; part < run.work.system.worlds(); ++part)
        f(part, contain_if_unsound(run, part, may_diverge));
}

}  // namespace epode
