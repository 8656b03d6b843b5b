// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An island whose solution is not finite is contained: it keeps its velocities, its constraints exert nothing, and other islands are
// unaffected. One whose sweeps diverge (divergence.h) is set aside to be solved in another way, if there is one.
#pragma once

#include "step/island/island_run.h"

namespace epode {

// Are its velocities such as a program may set?
bool keeps_numbers(const Body& body);

// Of a part, with all that the solution has written.
void contain_part(IslandRun& run, int part);
// Has the part's solution thrown its bodies?
bool part_has_diverged(const IslandRun& run, int part);
// Where nothing is known of the solution: the whole island keeps its velocities, and its poses advance with them.
void contain_island(IslandRun& run);

// Looks at part after part of a solution; contains what is not finite, and what `may_diverge` and has. f(part, contained) is called
// for each.
template <typename Judged>
void contain_unsound(IslandRun& run, bool may_diverge, Judged&& f)
{
    for (int part = 0; part < run.work.system.worlds(); ++part) {
        const bool contained = !run.is_sound(part) || (may_diverge && part_has_diverged(run, part));
        if (contained) contain_part(run, part);
        f(part, contained);
    }
}

}  // namespace epode
