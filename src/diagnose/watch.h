// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world's diagnosis: a StepObserver that notes the bodies before each step and lets the causes look after it.
#pragma once

#include "diagnose/findings.h"
#include "step/step.h"

namespace epode {

// False: out of memory, nothing changed. Off forgets all findings.
bool set_diagnosis(World& world, bool on);
// Null: the world is not diagnosed.
const Findings* findings_of(const World& world);

}  // namespace epode
