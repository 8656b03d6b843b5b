// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Auto-disable: a body whose averaged velocity stays under its thresholds for some steps and some time is put
// to sleep. Only bodies with a joint are looked at, so a body in free flight never sleeps at its apex.
#pragma once

#include "dynamics/world.h"

namespace epode {

// One pass over the world before a step of size h.
void auto_disable(World& world, Real h);

}  // namespace epode
