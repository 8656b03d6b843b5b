// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which derivatives of a step are asked for, and how they are found (derivatives.h).
#pragma once

#include "batch/model/parameters.h"

namespace epode::batch {

struct DerivativeOptions {
    bool exact = false;
    double distance = 0;  // of each side from the state, in its unit; 0: what rounding and curvature want
};

// A block of columns, (tangents, columns) row by row in the copies' own numbers: of the state's tangents and activations, of controls,
// or of a parameter.
struct ColumnBlock {
    enum Kind { kState, kControls, kParameter } kind;
    int columns;
    void* to;
    Parameter parameter = Parameter::kGravity;
};

}  // namespace epode::batch
