// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Newton's law of impacts for points that part while others strike. With u the normal velocity before and u' after a
// step, e the restitution and p the impulse, the impulses of a step change the energy by sum p (u + u')/2. What
// strikes has u' = -e u. A point that parts (u > 0) and is struck together by its neighbours must be free to
// reach u' = -e u too (Moreau's form of the law, u' + e u >= 0): with u' >= 0, as for a resting contact, its impulse
// adds p u/2, and a cradle whose balls touch gained 15 % of its energy. A velocity that only
// corrects the depth is no motion that could be returned.
#pragma once

#include <algorithm>

#include "rows/row.h"

namespace epode {

// The least normal velocity that the row asks for, where `c` is that of a contact at rest.
inline Real separating_target(const Row& normal, Real c)
{
    const Real returned = std::min(normal.restitution_velocity, Real(0)) + std::max(c, Real(0));
    return c + std::min(returned, Real(0));
}

}  // namespace epode
