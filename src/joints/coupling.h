// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step needs of couplings besides their rows.
#pragma once

#include "dynamics/coupling.h"

namespace epode {

Real coupling_rate(const CouplingJoint& coupling);  // ds/dt

// The dJointFeedback of members: cleared before joints write theirs, since members without rows do not, and
// afterwards increased by what the coupling exerts on their axes.
void clear_feedback_of_members(const CouplingJoint& coupling);
void add_feedback_of_members(const CouplingJoint& coupling);

}  // namespace epode
