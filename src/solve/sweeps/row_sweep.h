// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows of any form, one at a time: contacts that solve/sweeps/contact_set.h does not pack (rolling friction,
// one tangent). The two tangents of a contact whose friction is a cone are visited together, as there: steps with
// one gain, that of the larger eigenvalue of the two rows, then shortened into the ellipse of their limits.
// Everything that a visit needs is in one record, because a row is visited once per sweep and not again before
// it has left the caches.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/common/velocities.h"

namespace epode {

struct PackedRow {
    Vec3 lin1, ang1, lin2, ang2;
    Vec3 turn1, turn2;                         // I^-1 ang
    Real c, impulse_scale, effective_mass, p;  // q = clip(impulse_scale p + effective_mass (c - J v))
    Real lo, hi;                               // of a row with a parent: hi is the coefficient
    int parent;                                // packed row, or -1
    int source;                                // row of the system
};

struct PackedBlock {
    int first, count;
    int body1, body2;  // into the velocities
    Real inv_mass1, inv_mass2;
    bool cone;  // of the second and third row
};

class RowSweep {
  public:
    // Packs the blocks not marked in `skip`; false: out of memory.
    bool pack(const RowSystem& system, Real w, std::span<const bool> skip, Arena& arena);

    void apply_impulses(std::span<Velocity> bodies) const;  // v += M^-1 J^T p
    void sweep(std::span<Velocity> bodies, bool backwards);
    void visit(std::span<Velocity> bodies, int block, int row);
    void store_impulses(std::span<RowNumbers> numbers) const;

    std::span<PackedRow> rows() { return rows_; }
    std::span<const PackedBlock> blocks() const { return blocks_; }

  private:
    std::span<PackedBlock> blocks_;
    std::span<PackedRow> rows_;
};

inline Real row_velocity(const PackedRow& r, const Velocity& a, const Velocity& b)
{
    return (dot(r.lin1, a.v) + dot(r.ang1, a.w)) + (dot(r.lin2, b.v) + dot(r.ang2, b.w));
}

}  // namespace epode
