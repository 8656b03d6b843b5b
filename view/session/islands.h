// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which bodies hang together in a state, by joints and contacts: what a stepper solves as one. Static and
// kinematic bodies pass nothing on.
#pragma once

#include "view/session/stage.h"

namespace epode::view {

// For each body the lowest number of the bodies in its island.
std::vector<std::uint32_t> islands(const Stage& stage, const Moment& now);

}  // namespace epode::view
