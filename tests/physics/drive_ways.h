// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every way to step a world, for tests of what must hold in all of them, and the implicit law of a driven
// axis as a scalar problem of its own: inertia m, position q, rate w, other force F, step h,
//
//   (m + I)(w' - w)/h = F + clamp(f + k (t - q - h w') + d (u - w'), limit) - F_dry sign(w'),
//
// whose right side falls with w', so bisection finds its one root; a stop at `high` in reach caps w'.
#pragma once

#include <algorithm>

#include "rig.h"

namespace epode::physics {

enum class Way { kExact, kExactSubsteps, kQuick, kSubsteps, kJointsExact, kHybrid, kBatch };
inline constexpr Way kWays[] = {Way::kExact,       Way::kExactSubsteps, Way::kQuick, Way::kSubsteps,
                                Way::kJointsExact, Way::kHybrid,        Way::kBatch};

inline const char* name_of(Way way)
{
    constexpr const char* kNames[] = {"Exact",       "ExactSubsteps", "Quick", "Substeps",
                                      "JointsExact", "Hybrid",        "Batch"};
    return kNames[int(way)];
}
inline std::string way_name(const testing::TestParamInfo<Way>& info) { return name_of(info.param); }

inline constexpr int kSubstepCount = 4;

// In how many parts a step of that way integrates.
inline int parts_of(Way way)
{
    return way == Way::kExact || way == Way::kQuick || way == Way::kHybrid || way == Way::kBatch
               ? 1
               : kSubstepCount;
}

inline void step(Sim& sim, Way way, double h, int count = 1)
{
    if (way == Way::kBatch) {
        ASSERT_EQ(dWorldsStep(&sim.world, 1, real(h), dStepperExact, 0, count, 1, nullptr), 1);
        return;
    }
    dWorldSetExactSubsteps(sim.world, way == Way::kExactSubsteps ? kSubstepCount : 1);
    dWorldSetHybridSubsteps(sim.world, kSubstepCount);
    dWorldSetHybridStepper(sim.world, way == Way::kJointsExact ? dStepperSubstepsExactJoints : 0);
    for (int i = 0; i < count; ++i) {
        switch (way) {
            case Way::kQuick:
                ASSERT_EQ(dWorldQuickStep(sim.world, real(h)), 1);
                break;
            case Way::kSubsteps:
                ASSERT_EQ(dWorldStepFast1(sim.world, real(h), kSubstepCount), 1);
                break;
            case Way::kJointsExact:
            case Way::kHybrid:
                ASSERT_EQ(dWorldStepHybrid(sim.world, real(h)), 1);
                break;
            default:
                ASSERT_EQ(dWorldStep(sim.world, real(h)), 1);
        }
    }
}

inline dDrive no_drive()
{
    dDrive drive;
    dDriveInit(&drive, sizeof drive);
    return drive;
}

struct DrivenAxis {
    double mass = 1;
    dDrive drive = no_drive();
    double other_force = 0;
    double high = HUGE_VAL;  // a stop, with this ERP per step or substep
    double erp = 0.2;

    // What the drive pulls with when the rate becomes `next`.
    double pull(double q, double next, double h) const
    {
        const double limit = drive.force_limit > 0 ? double(drive.force_limit) : HUGE_VAL;
        const double free = drive.force + drive.stiffness * (drive.target - q - h * next) +
                            drive.damping * (drive.target_velocity - next);
        return std::min(std::max(free, -limit), limit);
    }
    double next_rate(double q, double w, double h) const
    {
        const auto missing = [&](double next, double friction) {
            return other_force + pull(q, next, h) + friction - (mass + drive.armature) * (next - w) / h;
        };
        const auto root = [&](double friction) {
            double low = -1e6, up = 1e6;
            for (int i = 0; i < 200; ++i) {
                const double middle = (low + up) / 2;
                (missing(middle, friction) > 0 ? low : up) = middle;
            }
            return (low + up) / 2;
        };
        double next = 0;
        if (const double up = root(-drive.friction); up > 0) next = up;
        if (const double down = root(drive.friction); down < 0) next = down;
        return q >= high ? std::min(next, erp / h * (high - q)) : next;
    }
};

}  // namespace epode::physics
