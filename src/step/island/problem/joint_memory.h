// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What joints carry from step to step. Forces persist and impulses do not, so a step of size h starts from
//
//   p = h (m + d (f - m)) s          f: the force of the last step; m: its mean over some seconds; d, s <= 1
//
// whatever method, step size and number of substeps f comes from. A structure at rest has f = m, and no
// change of these is felt. The rows of a stop or a motor come and go; the locked rows before them keep theirs.
//
// Why d. A visit of a joint removes the error of its own bodies. Of an error that many joints share, such as
// the sag of a bridge, a sweep removes a small share L only. Per substep, with the error e, its rate v, the
// kept impulse y (a velocity) and the share b of e that the correction asks for,
//
//   v += y,   y -= L (b e + v),  v -= L (b e + v),   e += v,   y -= L v,  v -= L v
//
// is a spring that rings: for small L  z^3 + 3 L z^2 + 2 L z + L b = 0 with solutions exp(z k), which grow by
// b/4 a substep where 6 L < b. If y loses a share k of itself in each substep they decay from k = b/2 on, thus
// from a loss of q = n b/2 in a step. A loss from all of f lets structures sag further the stiffer they should
// be; a loss from f - m only damps: d = 1/(1 + r + r^2/2), close to exp(-r), with r = 2.5 q. The mean is taken
// as lying between 0 and 2 f, so that what a joint has carried long ago counts for no more than what it carries.
//
// Only rows that lock, of joints without a soft row, have such a mean. Motors and stops act by what they meet,
// and a car on its suspension is no structure: its heading wandered by 1 degree in 5 s.
//
// Why s. Joints in loops can pull on each other for nothing, and no velocity shows it: s = 0.999 forgets such
// stress in a few seconds.
#pragma once

#include "dynamics/joint.h"
#include "rows/row_system.h"

namespace epode {

// Writes what the joint remembers into the numbers of its rows; `wanted`: the share that the program wants of it; `share`: of
// that, the stepper's own; `substeps`: in which the rows find it, 0: none.
void load_memory(LastingJoint& joint, const RowBlock& block, const RowSystem& system, Real wanted, Real share,
                 int substeps);

// Notes the forces of a step whose impulses have been written back.
void note_mean_force(LastingJoint& joint, const RowBlock& block, const RowSystem& system, Real h);

// Times an impulse of the joint: what it is in a step of size h.
inline Real step_ratio(const LastingJoint& joint, Real h)
{
    return joint.impulse_step > 0 ? h / joint.impulse_step : Real(1);
}

}  // namespace epode
