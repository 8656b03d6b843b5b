// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Auto-disable. With a and b the body's thresholds for linear and angular velocity, it is idle in a step if
//
//   |mean v| <= a  and  |mean w| <= b        ODE's rule: the mean over its number of samples
//   |x - x'| <= a T  and  |turn| <= 5 b T    it is still: all along the last window of T = 0.5 s or 4 s,
//                                            which began at the pose x'
//
// and ready to sleep when it has been idle for its number of steps and time. The second rule counts where
// something touches: contacts that are solved approximately tremble about a mean with speeds above any useful
// threshold, and a rock may rock for minutes. Its angle is larger, since equal thresholds are those of a body
// of 1 m radius. A mechanism that only its joints hold keeps ODE's rule alone: a motor may shake it on
// purpose.
//
// An island falls asleep as a whole, when all its bodies are ready, or nine in ten are and the others have
// been within the bounds of the long window for a second. To stop each body as soon as it is ready, as ODE
// does, takes momentum that its awake neighbours keep, step after step, and shakes piles apart. Bodies
// without a joint or contact are not looked at, so one in free flight never sleeps at its apex.
#pragma once

#include "dynamics/island.h"

namespace epode {

// How much of an island could sleep, as fall_asleep() has found.
struct Readiness {
    int bodies = 0, ready = 0;  // those that sleep already are ready
    bool watched = true;        // all of them may fall asleep
    bool touches = false;       // there are contacts
};

// Notes how idle the awake bodies of an island are, at the beginning of a step of size h. True: they have
// been put to sleep, and the island is none of this step's.
bool fall_asleep(const Island& island, Real h, Readiness& found);

// The same of one awake body, by ODE's rule alone and whatever its neighbours do: a world with ODE's behaviour.
bool fall_asleep_alone(Body& body, Real h);

}  // namespace epode
