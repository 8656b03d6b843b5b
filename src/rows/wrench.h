// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the rows of a joint exert on its bodies, f = sum p lin and t = sum p ang. Solvers with substeps add it
// up after every substep, with the Jacobian of then, for joints whose feedback or break limits want it:
// directions turn within a step, and a joint may choose other ones (two directions perpendicular to an axis),
// so impulses added up row by row mean nothing in the end.
#pragma once

#include "rows/row_system.h"

namespace epode {

struct BlockWrench {
    Vec3 f1, t1, f2, t2;  // on bodies 1 and 2, torques about their centres
    Vec3 couple;          // on body 1, about the anchor

    // Row i of the system, with the impulse p.
    void add(const RowBlock& block, int i, const Row& row, Real p)
    {
        f1 += p * row.lin1, t1 += p * row.ang1;
        f2 += p * row.lin2, t2 += p * row.ang2;
        const bool at_anchor = block.form != RowForm::kFree && i < block.first + 3;
        if (!at_anchor) couple += p * (row.ang1 - cross(block.arms.r1, row.lin1));
    }
};

inline BlockWrench operator*(Real s, const BlockWrench& w)
{
    return {s * w.f1, s * w.t1, s * w.f2, s * w.t2, s * w.couple};
}

// Of the whole step, times `scale`: 1 for impulses, 1/h for forces.
inline BlockWrench wrench_of(const RowSystem& system, const RowBlock& block, Real scale)
{
    if (block.wrench >= 0) return scale * system.wrenches[std::size_t(block.wrench)];
    BlockWrench sum;
    for (int i = block.first; i < block.first + block.count; ++i)
        sum.add(block, i, system.rows[std::size_t(i)], scale * system.numbers[std::size_t(i)].p);
    return sum;
}

}  // namespace epode
