// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Islands that are about to come to rest. A few sweeps leave errors in every step, of some percent of what
// gravity adds, and these keep a heap trembling and creeping for ever, although what is missing is only a
// better answer. An island whose bodies may all fall asleep, and nine in ten of which hardly move, is
// therefore settled:
//
//  - it is solved with more sweeps or small steps: for a second or two, and then it costs nothing;
//  - its contact joints may keep some depth: pushed out entirely they open, and what they held falls;
//  - its stragglers, such as a rock that rocks between others, are braked as rolling resistance would.
//
// It is left alone if it has not fallen asleep after some seconds: then something is not meant to rest.
// Without auto-disable there is no settling, and steps are what they would be otherwise.
#pragma once

#include "dynamics/sleep.h"

namespace epode {

// To be called when the island does not fall asleep; notes in it whether it settles, and brakes its
// stragglers.
void settle(Island& island, Real h, const Readiness& found);

}  // namespace epode
