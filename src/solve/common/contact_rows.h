// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joint manifolds from contacts that are given as rows, for solvers that pack manifolds. Consecutive blocks
// of one pair of bodies with the same directions and friction numbers form a manifold. Blocks that are not a
// normal row with none or two tangents are left to other code. Manifolds that the system has already come first.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/joint_manifold.h"
#include "rows/row_system.h"

namespace epode {

class ContactRows {
  public:
    // Marks the blocks that become points of manifolds; false: out of memory.
    bool gather(const RowSystem& system, std::span<bool> taken, Arena& arena);

    const JointManifoldList& list() const { return list_; }
    // The normal row that a point came from, in a system that had no manifolds.
    int row_of(int point) const { return rows_[std::size_t(point)].normal; }
    // Into the points and rows that they came from.
    void store_impulses(RowSystem& system) const;

    // Calls f(number of the row, impulse) for each row of each point that came from rows.
    template <typename Visit>
    void for_each_impulse(Visit&& f) const
    {
        for (std::size_t i = 0; i < rows_.size(); ++i)
            for (int k = 0; k < rows_[i].count; ++k) f(rows_[i].normal + k, list_.points[i + given_].p[k]);
    }

  private:
    struct PointRows {
        int normal, count;
    };

    bool reserve(const RowSystem& system, int contacts, Arena& arena);

    JointManifoldList list_;
    std::size_t given_ = 0;      // points that the system has already
    std::span<PointRows> rows_;  // of the points after them
};

// True if the block is a contact that fits a manifold; and the manifold that it would be a point of.
bool has_contact_form(const RowSystem& system, const RowBlock& block);
JointManifold manifold_of(const RowSystem& system, const RowBlock& block);

// True if the block's second and third row are friction in two directions that is bounded by an ellipse.
bool has_cone(const RowSystem& system, const RowBlock& block);

// The inverse: the system with its manifolds as additional rows, for code that judges rows. False: out of
// memory.
[[nodiscard]] bool expand_manifolds(const RowSystem& system, Arena& arena, RowSystem& out);

}  // namespace epode
