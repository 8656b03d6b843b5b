// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The direction of a rod's row turns with the rod: its length is the lever by which an opening is long or short, also where the ends are
// the bodies' centres and no arm of a Jacobian shows it.
#pragma once

#include "dynamics/joint.h"

namespace epode {

// Of a double ball or double hinge; 0: the joint is no rod.
Real rod_length(const Joint& joint);

}  // namespace epode
