// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The rows that a projection holds, and how far they are off.
//
// Equalities and stops of joints, contact normals; not motors, friction, and what is a spring (position_rows.h). Errors are read from the
// joints at every pose; contacts, and rows whose error does not answer to the pose (Plane2D's rates, angles that the client hands in), follow
// the motion to first order: e <- e - J dx. Contacts lose their ERP's share of the depth in a step: all at once, a pile that is wedged pushes
// itself apart for ever. They keep half the tolerance, so that they are found again.
//
// Rotors of drives are part of M: each is a row that holds nothing, J dx + p/I = 0.
#pragma once

#include "step/island/positions/asked.h"

namespace epode {

// What a row of the projection needs besides its Row in the system.
struct Hold {
    int source;        // row of the step
    Real error;        // J dx = error
    Real per_arm;      // 1/l
    bool follows;      // the motion, as the pose does not determine its error
    Real inertia = 0;  // of a rotor, which holds nothing: J dx + p/inertia = 0 is its share of the metric
};

class HeldRows {
  public:
    HeldRows(const World& world, const IslandWork& work);

    // Chooses them at the poses that the step has reached, into `to`, without its bodies. False: out of memory, or nothing to hold.
    bool choose(Arena& arena, RowSystem& to);

    // Largest e/l, and the sum of its squares.
    Real worst() const { return worst_; }
    Real merit() const { return merit_; }
    bool one_sided() const { return one_sided_; }
    // What all errors ask for in one step of length 1: those of contacts, or of joints.
    Asked asked(bool by_contacts) const;
    // Of all rows that follow the motion.
    Real followed_errors() const;
    const RowBlock& source_of(std::size_t block) const;

    // The numbers of `system` for a Newton step, rows that hold being as soft as that, of the inverse effective mass.
    void load_numbers(RowSystem& system, Real softness) const;

    // A step begins here, of which `follow` takes a share: bodies have been moved by that of the displacements of the system's.
    void begin();
    void follow(RowSystem& system, Real share);

  private:
    const Row& step_row(const Hold& hold) const { return work_.system.rows[std::size_t(hold.source)]; }
    const Body& body(int i) const { return *work_.island.bodies[std::size_t(i)]; }
    void choose_rows(RowSystem& to);
    int choose_rows_of(int k, std::span<const Row> now, RowSystem& to, int rows);
    Hold hold_of(const Row& row, int k, int source, const Row* now, Real per_arm) const;
    void aim_at_depth(const Row& normal, int block, Real per_arm, Hold& hold) const;
    Real motion(const Row& row, const RowBlock& block) const;
    Real to_close(const Hold& hold) const;
    void measure();
    void update(RowSystem& system, std::size_t k, Real share);

    const World& world_;
    const IslandWork& work_;
    StepInfo info_;
    std::span<Hold> holds_, before_;  // parallel to the system's rows
    std::span<int> from_;             // block of the step that a block is of
    bool one_sided_ = false;
    Real worst_ = 0, merit_ = 0;
};

}  // namespace epode
