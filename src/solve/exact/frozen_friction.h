// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A system whose friction has limits and directions of its own, frozen: the box problems of coulomb.h.
#pragma once

#include <span>

#include "rows/row_system.h"
#include "solve/exact/anderson.h"

namespace epode {

class FrozenFriction {
  public:
    explicit FrozenFriction(RowSystem& system) : system_(system), frozen_(system) {}
    // False: out of memory.
    bool prepare(Arena& arena);

    // How far the friction of the present answer is from Coulomb's, relative to the problem's velocities.
    Real judge();
    // The system, unsolved, with the limits and directions that follow from the answer judged last.
    RowSystem& freeze();
    // Takes the impulses of its solution.
    void thaw();

    // The answer to restore.
    void keep();
    void restore();

  private:
    struct Twist {
        Vec3 v, w;
    };
    // A contact's friction in units in which its ellipse is a disc: p_2 = ratio times the impulse along the
    // second tangent, which is `ratio` times as long. The first direction is c of the first tangent and s of
    // the second.
    struct Turn {
        Real c = 1, s = 0, ratio = 1;
    };
    // Where friction q = p - w/d would be in these units, and how fast it slides along -q.
    struct Sliding {
        Real d = 0, p[2] = {}, q[2] = {}, length = 0, speed = 0;
    };

    void yield(const RowBlock& block, std::size_t row);
    Real judge(const RowBlock& block) const;
    void freeze(const RowBlock& block, Real normal, Turn& turn);
    Turn freeze_disc(const RowBlock& block, Real normal);
    void turn_tangents(std::size_t first, Turn turn);
    void couple(std::size_t first, Turn turn, const Sliding& last);
    void turn_back(std::size_t first, Turn turn);
    void set_limit(std::size_t row, Real limit);

    bool is_disc(const RowBlock& block) const;
    Real ratio(std::size_t first) const;
    Sliding sliding(const RowBlock& block) const;
    Real limit(std::size_t row, Real normal) const;
    Real normal_impulse(const RowBlock& block) const;
    Real inverse_mass(const RowBlock& block, std::size_t row) const;
    Real slip(const RowBlock& block, std::size_t row) const;

    void measure_scale();
    void save(std::span<Twist> out) const;
    void load(std::span<const Twist> in);

    RowSystem& system_;
    RowSystem frozen_;
    std::span<Twist> begun_, kept_twists_;
    std::span<Real> kept_impulses_;
    std::span<double> normals_, weights_;  // of the blocks: impulse, and d of its row
    std::span<Turn> turns_;                // of the blocks
    Anderson anderson_;
    Real scale_ = 1;
};

}  // namespace epode
