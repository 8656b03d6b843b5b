// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/problem/joint_memory.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Real kMeanTime = 20;       // s
constexpr Real kKept = Real(0.999);  // s above
constexpr Real kMargin = Real(2.5);

// The rows that are the same in every step: those that lock come first.
int locked_rows(const RowBlock& block, const RowSystem& system)
{
    int count = 0;
    while (count < block.count && system.rows[std::size_t(block.first + count)].kind == RowKind::kLock)
        ++count;
    return count;
}

// How many rows of the block are the first of `remembered` ones.
int same_rows(int remembered, const RowBlock& block, const RowSystem& system)
{
    if (remembered == block.count) return remembered;
    return std::min(remembered, locked_rows(block, system));
}

bool has_soft_row(const RowBlock& block, const RowSystem& system)
{
    const auto rows = system.rows.subspan(std::size_t(block.first), std::size_t(block.count));
    return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.soft; });
}

// d of a row in n substeps.
Real damping(Real erp, int n)
{
    const Real left = 1 - erp * (1 - 1 / Real(n));
    if (!(left > 0)) return 0;
    const Real r = kMargin * erp / (2 * left);
    return 1 / (1 + r + r * r / 2);
}

Real bounded_mean(Real mean, Real force)
{
    return force > 0 ? std::clamp(mean, Real(0), 2 * force) : std::clamp(mean, 2 * force, Real(0));
}

}  // namespace

void load_memory(LastingJoint& joint, const RowBlock& block, const RowSystem& system, Real wanted, Real share,
                 int substeps)
{
    if (joint.impulse_rows == 0) joint.mean_rows = 0, joint.mean_time = 0;
    const int same = same_rows(joint.impulse_rows, block, system);
    const Real ratio = step_ratio(joint, system.h);
    const bool lasts = substeps > 0 && !has_soft_row(block, system);
    for (int i = 0; i < same; ++i) {
        const auto row = std::size_t(block.first + i);
        const Real p = ratio * joint.impulse[i];
        if (!lasts || i >= joint.mean_rows || system.rows[row].kind != RowKind::kLock) {
            system.numbers[row].p = wanted * share * p;
            continue;
        }
        const Real mean = bounded_mean(system.h * joint.mean[i], p);
        system.numbers[row].p =
            wanted * kKept * (mean + damping(system.rows[row].erp, substeps) * (p - mean));
    }
}

void note_mean_force(LastingJoint& joint, const RowBlock& block, const RowSystem& system, Real h)
{
    const int same = same_rows(joint.mean_rows, block, system);
    joint.mean_rows = joint.impulse_rows;
    joint.mean_time = same > 0 ? std::min(kMeanTime, joint.mean_time + h) : h;
    for (int i = 0; i < int(joint.mean_rows); ++i) {
        const Real force = joint.impulse[i] / joint.impulse_step;
        joint.mean[i] = i < same ? joint.mean[i] + h / joint.mean_time * (force - joint.mean[i]) : force;
    }
}

}  // namespace epode
