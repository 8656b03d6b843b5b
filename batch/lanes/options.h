// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Of a step, the same for all copies.
#pragma once

namespace epode::batch {

struct StepOptions {
    double h = 0.002;            // s
    double erp = 0.2;            // the share of an overlap or of a limit passed that a step takes back
    double most_correction = 2;  // m/s or rad/s, of taking back
    double reach = 0.005;     // m: surfaces nearer than this, and what they may approach in a step, have rows
    double tolerance = 1e-6;  // m/s: what a row's last change may be
    int most_sweeps = 200;
    double evening = 0.05;  // of a face's load, how far a step draws its points to their mean (sharing.h)
};

}  // namespace epode::batch
