// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which turn an angle is in. Two bodies say what an angle a is up to whole turns; the angle of the last step,
// from which it has moved by less than half a turn, says which of a + 2 pi n it is. So stops may be anywhere,
// and an arm that a step carries across the gap between them is still beyond the stop that it has passed.
// Without a last step (the program has placed the bodies, or there were no stops) the angle is the one nearest
// to the middle of the range [lo, hi]: what is outside belongs to the nearer stop. In a range of a turn or
// more several angles are possible; there it is the one nearest to the last that was counted, 0 at first.
#pragma once

#include "base/config.h"

namespace epode {

// The angle + 2 pi n that is nearest to `to`.
Real nearest_turn(Real angle, Real to);

struct TurnCount {
    bool continuous = false;  // the program has the turns counted
    bool follows = false;     // `last` is the angle of the last step
    Real last = 0;

    // The angle that is `angle` up to whole turns, between these stops or beyond them.
    Real of(Real angle, Real lo, Real hi) const;
    void take(Real counted) { last = counted, follows = true; }
};

}  // namespace epode
