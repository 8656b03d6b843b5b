// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/displacement.h"

#include <algorithm>

#include "step/island/containment.h"
#include "step/island/positions/asked.h"
#include "step/island/positions/solved_motion.h"

namespace epode {
namespace {

struct Displacement {
    double moved = 0, moving = 0, mass = 0;  // sums of m u^2, m (v0^2 + v1^2) and m

    bool is_far(double asked) const
    {
        return moved > 2 * (moving + mass * double(kCorrecting * kCorrecting) + asked);
    }
};

Displacement displacement_of(const IslandRun& run, int part)
{
    const std::span<Body* const> bodies = run.bodies_of(part);
    const StepUndo& undo = run.context.undo;
    const std::size_t first = undo.first_of(bodies);
    const Real rate = 1 / run.context.h;
    Displacement sum;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body& body = *bodies[i];
        if (body.kinematic()) continue;
        const Real m = body.mass.mass;
        const Vec3 u = rate * (body.position() - undo.pose_before(first + i).p);
        sum.mass += double(m), sum.moved += double(m * length2(u));
        sum.moving += double(m * (length2(undo.velocity_before(first + i)) + length2(body.velocity())));
    }
    return sum;
}

// Stiff springs of the program move bodies within a step to where their velocity is small again.
bool has_springs(const IslandRun& run, int part)
{
    const RowSystem& system = run.work.system;
    for (int k = system.begin_of(part).blocks; k < system.end_of(part).blocks; ++k) {
        const RowBlock& block = system.blocks[std::size_t(k)];
        const auto own = system.rows.subspan(std::size_t(block.first), std::size_t(block.count));
        if (std::any_of(own.begin(), own.end(), [](const Row& row) { return row.drive || row.soft; }))
            return true;
    }
    return false;
}

bool is_displaced(const IslandRun& run, int part)
{
    if (has_springs(run, part)) return false;
    const Displacement sum = displacement_of(run, part);
    return sum.is_far(0) && sum.is_far(asked_by_errors(run.work, part, run.context.h));
}

}  // namespace

void set_displaced_aside(IslandRun& run, bool iterates)
{
    if (!bounds_corrections(run) || run.context.correction < 1) return;
    if (iterates && !run.may_try_again) return;
    if (run.solved.method == dIslandMethodJointCoordinates)
        return;  // joints that poses close move by their coordinates
    for (int part = 0; part < run.work.system.worlds(); ++part)
        if (!run.is_free(part) && !run.set_aside[std::size_t(part)].is && is_displaced(run, part))
            run.set_aside[std::size_t(part)] = {true, iterates ? Real(1) : Real(0.5)};
}

}  // namespace epode
