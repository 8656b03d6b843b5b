// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What must happen when the last dCloseODE balances the first dInitODE: user geom classes and collider
// overrides are forgotten, empty pools give back what the program's handlers gave. The folders that own such
// state hand in a function here, so that the layer which counts (api) needs to know none of them. A
// registration at run time, by the code that first creates the state, and not by static objects: those would
// depend on initialisation order and on what a linker keeps of a static library.
#pragma once

namespace epode {

// Remembers `hook` for every last close from now on; a hook that is known already is not added again.
// False when the table (32 entries) is full.
bool on_last_close(void (*hook)()) noexcept;

// Runs the hooks, the newest first.
void run_close_hooks() noexcept;

}  // namespace epode
