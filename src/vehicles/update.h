// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One update of a vehicle: steer and shift, find what the wheels stand on, solve for their forces, apply
// them. A vehicle that has fallen asleep stays so, and costs a look at what it stands on.
#pragma once

#include "vehicles/wheel_contact.h"

namespace epode {

// False: out of memory, nothing has changed. `space` has been cleaned; null: the wheels find nothing.
[[nodiscard]] bool update_vehicle(Body& body, Space* space, Real h);

// Asleep, and nothing has happened that wakes it.
bool keeps_sleeping(const Body& body);

}  // namespace epode
