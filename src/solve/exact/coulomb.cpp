// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/exact/coulomb.h"

#include <algorithm>
#include <cmath>

#include "solve/common/work_meter.h"
#include "solve/exact/frozen_friction.h"

namespace epode {
namespace {

// How many box problems may follow the first, and how many of them in a row without a better answer. In piles that tumble the
// fixed point often wanders; there a solve costs much, and the first few gain most.
struct Patience {
    int passes, idle;
};
constexpr int kLargeRows = 300;
constexpr Patience kSmall{30, 8}, kLarge{8, 3};
constexpr Real kCoulomb = sizeof(Real) == 8 ? Real(1e-7) : Real(1e-5);

// The best answer so far, and what its report says of it.
class Best {
  public:
    Best(FrozenFriction& friction, const SolveReport& report, Real error) : friction_(friction)
    {
        take(report, error);
    }

    void offer(const SolveReport& report, Real error)
    {
        error < error_ ? take(report, error) : void(++idle_);
    }
    int idle() const { return idle_; }
    void restore(SolveReport& report)
    {
        friction_.restore();
        report.residual = residual_, report.friction_error = error_;
    }

  private:
    void take(const SolveReport& report, Real error)
    {
        friction_.keep();
        error_ = error, idle_ = 0, residual_ = report.residual;
    }

    FrozenFriction& friction_;
    Real error_ = 0, residual_ = 0;
    int idle_ = 0;
};

}  // namespace

bool solve_coulomb(SolveBoxes solve, RowSystem& system, const ExactSettings& settings, Arena& arena,
                   SolveReport& report)
{
    Arena::Scope scope(arena);
    FrozenFriction friction(system);
    if (!friction.prepare(arena) || !solve(system, settings, arena, report)) return false;
    if (report.gave_up) return true;
    const Patience patience = int(system.rows.size()) > kLargeRows ? kLarge : kSmall;
    Real error = friction.judge();
    Best best(friction, report, error);
    for (int pass = 0; error > kCoulomb && pass < patience.passes && best.idle() < patience.idle; ++pass) {
        if (settings.work && settings.work->exhausted()) break;
        if (!solve(friction.freeze(), settings, arena, report)) return false;
        if (report.gave_up) break;
        friction.thaw();
        error = friction.judge();
        best.offer(report, error);
    }
    report.gave_up = false;
    best.restore(report);
    return true;
}

}  // namespace epode
