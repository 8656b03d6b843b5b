// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What happens when the last dCloseODE balances the first dInitODE: user geom classes and collider overrides
// are forgotten, and empty pools return memory that came from the program's handlers. Folders that own such
// state register a function here, so that the layer that counts the calls (api) need not know them. State
// registers itself at run time, when it is first created. Static objects would depend on the order of
// initialisation and on what a linker keeps of a static library.
#pragma once

namespace epode {

// Registers `hook` for every last close from now on; registering twice has no further effect. False when the
// table (32 entries) is full.
bool on_last_close(void (*hook)()) noexcept;

// Runs the hooks, the newest first.
void run_close_hooks() noexcept;

}  // namespace epode
