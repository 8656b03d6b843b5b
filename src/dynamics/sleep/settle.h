// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Islands that are about to come to rest. Few sweeps leave errors of some percent of what gravity adds in
// every step, and these keep a pile trembling and creeping for ever although only a better solution is
// missing. An island whose bodies may all fall asleep, and nine in ten of which hardly move, is therefore
// settled:
//
//  - it is solved with more sweeps or substeps, for a second or two; asleep, it costs nothing. Its joints are
//    solved exactly instead where they are not too many: what they leave open and how stiff they are depends on
//    the number of substeps, and a structure that alternates between two numbers shakes itself to pieces;
//  - its contact joints may keep some depth: without any they would open, and bodies would fall;
//  - its stragglers, such as a rock that rocks between others, are braked as by rolling resistance.
//
// Settling ends if the island has not fallen asleep after some seconds: then something is not meant to rest.
// Without auto-disable there is no settling, and steps are unchanged.
#pragma once

#include "dynamics/sleep/sleep.h"

namespace epode {

// For an island that has not fallen asleep: stores in it whether it settles, and brakes its stragglers.
void settle(Island& island, Real h, const Readiness& found);

}  // namespace epode
