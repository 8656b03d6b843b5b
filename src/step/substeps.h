// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The model that a solver with inner steps drives: the bodies and joints of one island.
#pragma once

#include "rows/row_system.h"
#include "step/assemble.h"

namespace epode {

struct SubstepModel {
    IslandWork& work;
    StepInfo info;  // `inner` is set: joints keep the rows that they wrote at the beginning of the step

    Substeps callbacks();
};

// Lets a contact of two bodies act at one point of their present poses again: its arms are those of earlier
// ones, and half way between their ends lies the point that both bodies share.
void gather_contact(const Island& island, RowBlock& block, std::span<Row> rows);

}  // namespace epode
