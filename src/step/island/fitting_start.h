// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The impulses p of the last step as a start of this one. With v* the velocities after all forces, c the targets and C the compliances,
// sweeps only ever lower
//
//   D(p) = p J M^-1 J^T p/2 + p C p/2 + p (J v* - c),     D(0) = 0
//
// which is the kinetic energy that p adds, less what targets and springs take from it (step/island/divergence.h). Impulses along arms that
// have turned since, most of all arms longer than the radius of gyration, may begin with D(p) far above 0: then few sweeps end with energy
// from nowhere. Where D(p) exceeds a tenth of the part's kinetic energy and that of its mass at 0.3 m/s, it starts from its best share s p,
// which is below D(0) again: with a = p (J v* - c) and b = p (J M^-1 J^T + C) p, s = -a/b, at least 0. A little above 0 begin many that fit:
// a grip, a crank whose force changes sign.
//
// Rows whose bounds are one number have no choice: they are forces, and count in v*.
#pragma once

#include <span>

#include "base/arena.h"
#include "dynamics/body.h"
#include "rows/row_system.h"

namespace epode {

// Impulses of all rows and contacts, part by part, in one solution or in n substeps, of which each starts from its share. `bodies` have the
// forces that v* of substeps lacks.
void fit_start(RowSystem& system, std::span<Body* const> bodies, int substeps, Arena& arena);

}  // namespace epode
