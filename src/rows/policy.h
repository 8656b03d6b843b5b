// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Facts to numbers: how a stepper wants position error removed.
#pragma once

#include "rows/row_system.h"

namespace epode {

// ODE's meaning, for the whole step h:  c = min(erp/h error + speed, cap), at least the rebound.
RowNumbers ode_baumgarte(const Row& row, Real h, int block_first);

// The wanted velocity of a row with a given correction rate instead of erp/h.
Real wanted_velocity(const Row& row, Real rate);

}  // namespace epode
