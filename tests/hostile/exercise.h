// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The world goes on: after a call that was accepted the scene is collided and stepped with all three
// steppers.
#pragma once

#include "scene.h"

namespace hostile {

// False: a contact was not finite. The messages of the calls made here are not kept.
bool exercise(const Scene& scene);

}  // namespace hostile
