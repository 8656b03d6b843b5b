// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Newton's restitution after the last substep, as one problem over the constraints of an island in which
// something rebounds:
//
//   dp >= 0,   w = J v >= c,   dp (w - c) = 0
//
// c is the velocity of the rebound, e times the approach, where a contact approached fast and carried load. Others
// that touch may keep approaching as they do now; and those that separated when the step began, with s, may
// approach with e s (Moreau's law: without it impacts create energy). For the equality rows of joints, which
// pull too, c is their target. The substeps have brought what touches to a common velocity, so with the
// rebounding contacts alone, one after the other, a ball that hits a row of four would lose half of its energy:
// the three behind the first must go with it. Then friction under the larger impulses (impact_friction.h).
//
// Gauss-Seidel, island by island, until nothing changes any more; rows whose bodies have not changed are not
// visited again, so that far away from what rebounds there is nothing to do.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/substeps/impacts/impact.h"

namespace epode {

class Restitution {
  public:
    // `rebounds`: of each point of each contact manifold, or none: e times the approach, negative if it
    // separated; 0: it does not rebound.
    Restitution(RowSystem& system, std::span<const float> rebounds) : system_(system), rebounds_(rebounds) {}

    bool any() const;
    // `rows`: those of followed joints at the present pose. False: out of memory.
    bool apply(std::span<const Row> rows, Arena& arena);

  private:
    struct ImpactRow {
        Jacobian J;
        int body1, body2;  // body2 = -1: the world
        Real c;
        Real p;  // impulse of the substeps
        bool pulls;
        int block, source;  // of the row; -1: it is
        ContactManifold* manifold;
        ManifoldPoint* point;  // of it
        Real d = 0, dp = 0;    // J M^-1 J^T; change of p
        int seen = 0;
        Real hi = kInf;  // of p + dp
    };

    bool rebounds_in(int part) const;
    bool rebounds_at(const RowBlock& block) const;
    bool is_fixed(int body1, int body2) const;
    int row_limit(const SystemPart& from, const SystemPart& to) const;
    void list_rows(const SystemPart& from, const SystemPart& to, std::span<const Row> rows);
    void list_contacts(const SystemPart& from, const SystemPart& to, bool fixed);
    void list_joints(const SystemPart& from, const SystemPart& to, std::span<const Row> rows);
    void add(const ImpactRow& row, Real rebound);
    Real velocity_of(const ImpactRow& row) const;
    bool sweep();
    bool rub(Arena& arena);
    int last_change(int body1, int body2) const;
    void touch(int body1, int body2);
    void store() const;
    ImpactBodies bodies() const { return {system_.bodies}; }

    RowSystem& system_;
    std::span<const float> rebounds_;
    std::span<ImpactRow> list_;  // of the part
    std::size_t count_ = 0;
    std::span<int> changed_;  // of each body: the time of its last change; of rows: of their last visit
    int clock_ = 0;
    Real fastest_ = 0;  // of the rebounds of the part
};

}  // namespace epode
