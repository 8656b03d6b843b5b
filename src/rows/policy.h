// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From facts to numbers: how a stepper removes position errors. ERP and CFM as the guide defines them: CFM
// shifts J v by cfm * lambda, ERP asks for erp/h of the error. The restitution velocity replaces the
// correction where it is larger in the direction in which the row acts. The target of a drive with inertia I,
// damping d and stiffness k is
//   w' + lambda/D = (force + I w/h + k error + d velocity)/D,   D = I/h + d + h k
#pragma once

#include <algorithm>

#include "rows/row_system.h"

namespace epode {

// Of a row with a drive: c = rate * error + speed, J v + C p = c.
struct DriveAim {
    Real rate, speed, C;
};
inline DriveAim drive_aim(const RowDrive& drive, Real h)
{
    const Real D = drive.inertia / h + drive.damping + h * drive.stiffness;
    const Real force = drive.force + drive.inertia / h * drive.rate + drive.damping * drive.velocity;
    return {drive.stiffness / D, force / D, 1 / (h * D)};
}

// The numbers of a row with a drive, which replace those of ERP, CFM and speed. A pass of its own, since few
// rows have one.
inline void take_drive(const Row& row, Real h, RowNumbers& n)
{
    const DriveAim aim = drive_aim(*row.drive, h);
    n.c = aim.rate * row.error + aim.speed;
    n.C = aim.C;
}

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
