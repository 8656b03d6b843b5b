// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From facts to numbers: how a stepper removes position errors. ERP and CFM as the guide defines them: CFM
// shifts J v by cfm * lambda, ERP asks for erp/h of the error. The restitution velocity replaces the
// correction where it is larger in the direction in which the row acts.
#pragma once

#include <algorithm>

#include "rows/row_system.h"

namespace epode {

// The target velocity of a row with a given correction rate instead of erp/h.
inline Real wanted_velocity(const Row& row, Real rate)
{
    Real c = std::min(rate * row.error + row.speed, row.cap);
    if (row.has_restitution)
        c = row.lo >= 0 ? std::max(c, row.restitution_velocity) : std::min(c, row.restitution_velocity);
    return c;
}

// ODE's meaning, for the whole step h = 1/fps:  c = min(erp/h error + speed, cap), at least the restitution
// velocity.
inline RowNumbers ode_baumgarte(const Row& row, Real h, Real fps, int block_first)
{
    RowNumbers n;
    n.c = wanted_velocity(row, row.erp * fps);
    n.C = row.cfm * fps;
    if (row.parent >= 0) {
        n.parent = block_first + row.parent;
        n.hi = row.hi;
        n.lo = -row.hi;
    } else {
        n.lo = row.lo * h;
        n.hi = row.hi * h;
    }
    return n;
}
inline RowNumbers ode_baumgarte(const Row& row, Real h, int block_first)
{
    return ode_baumgarte(row, h, 1 / h, block_first);
}

}  // namespace epode
