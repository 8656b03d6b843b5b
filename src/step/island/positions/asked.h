// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What errors of positions may cost. Of all motions that make velocities c_i the solution is that of the least energy, so where nothing is
// wedged it has at most that of all bodies at once,
//
//   A/2 = (m sum c_i^2 + I sum of the squares of the angles' c_i) / 2,    m of the part, I about its centre of mass
//
// Near a dead centre levers would have to move a thousand times as far, and what closes joints and contacts would carry the part away. Whoever
// corrects positions compares with A: velocities (island/divergence.h), projections, and what is left of both (island/displacement.h).
#pragma once

#include "step/island/problem/assemble.h"

namespace epode {

// Sums of the squares of velocities that corrections ask for, m/s and rad/s.
struct Asked {
    double linear = 0, angular = 0;
    void add(const Jacobian& row, double c)
    {
        (length2(row.lin1) + length2(row.lin2) > 0 ? linear : angular) += c * c;
    }
};

// A without its bound: twice the energy of all bodies of a part at once.
double energy_of(const Asked& asked, const IslandWork& work, int part);

// The same of the velocities that would remove all errors of positions in a step of h.
double asked_by_errors(const IslandWork& work, int part, Real h);

}  // namespace epode
