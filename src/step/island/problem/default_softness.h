// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The default CFM is there for redundant rows and is no spring. It is a number per newton, so what it lets a row
// yield by grows with the load: 1e-5 under a box of 50 m is 3 km/s. A row that has it gets no more than
//
//   CFM <= s hs (1 - ERP (1 - hs/h)) d,    d = 1/m1 + 1/m2, of rows that only turn a.(I1^-1 + I2^-1) a,
//
// with which n bodies on top of one another lose at most n s g h of velocity in a step h, whatever their size. hs: the
// inner step, at which the limit is s d (solve/common/substep_rows.h). s of a joint is 1/2000, half of kSoftShare, so that
// neither substeps nor the projection (positions/position_rows.h) take the default for a spring that somebody wants. In floats
// it is 2e-6, or bridges and walls sag by what shows, each method by its own h or hs, and jump when the methods take turns. s
// of a contact is 1/100, in substeps 1/2000. d leaves out what lever arms add, so the points of a manifold stay
// alike. Any other CFM is the program's, and is literal. ODE has no such limit.
#pragma once

#include "dynamics/world.h"
#include "rows/row_system.h"

namespace epode {

// Of the rows and the numbers of a system whose step is system.h, and of its joint manifolds.
void limit_default_softness(const World& world, Real hs, RowSystem& system);

// Has this row the default, and not a spring, a slip or a joint's own CFM that is as large? (Contacts that the program
// makes soft may have set ERP alone.)
bool has_default_softness(const Row& row);

}  // namespace epode
