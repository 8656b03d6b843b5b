// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#pragma once

namespace epode {

// By the environment, else the newest.
int behaviour_of_new_worlds();

}  // namespace epode
