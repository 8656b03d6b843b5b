// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// n substeps of hs = h/n instead of n sweeps over one large step. Per substep:
//
//   v += hs M^-1 f, and the effect of rotation
//   correct the velocities, position errors included    solve/substeps/substep_solver.h
//   x += hs v
//   relax them, without the errors
//
// Errors of joints are measured at every pose, so mass ratios that would need hundreds of sweeps settle in ten
// substeps; on regular stacks there is no gain.
#pragma once

#include <algorithm>

#include "solve/substeps/substep_solver.h"

namespace epode {

// `solver` is prepared for `model`, which has the functions of SubstepModel (step/island/substep_model.h). `ends`, unless
// empty, gets the sum of the bodies' velocities at the end of each substep. False: out of memory.
template <typename Joints, typename Model>
bool make_substeps(SubstepSolver<Joints>& solver, Model& model, std::span<Velocity> ends, Arena& arena,
                   SolveReport& report)
{
    const std::span<Velocity> velocities = solver.velocities();
    const auto [hs, n] = solver.step();
    if (solver.may_rebound()) {
        const auto pushed = arena.take<Velocity>(int(velocities.size()));
        if (arena.failed()) return false;
        std::copy(velocities.begin(), velocities.end(), pushed.begin());
        model.apply_forces(pushed, hs);
        if (!solver.expect_rebounds(pushed, arena)) return false;
    }
    solver.begin();
    for (int i = 0; i < n; ++i) {
        const bool last = i == n - 1, judged = last && solver.judges();
        if (i > 0) model.refresh(velocities);
        model.apply_forces(velocities, hs);
        model.kick_spins(velocities, hs);
        if (judged) model.settle(), solver.begin_judged();
        solver.correct();
        if (judged && !solver.judge(report, arena)) return false;
        solver.follow_motion();
        model.advance(velocities, hs);
        solver.turn();
        solver.relax();
        add(ends, velocities.first(ends.size()));
        solver.end(last);
    }
    solver.store();
    model.settle();
    solver.add_contact_wrenches();
    model.gather_contacts();
    return solver.finish(arena);
}

}  // namespace epode
