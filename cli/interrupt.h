// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ctrl+C (SIGINT) and SIGTERM while files are being written: the step in progress is finished, files are made
// whole, and the command says so. A second one ends the program at once.
#pragma once

namespace epode::cli {

// While one lives, the first signal is only remembered.
class Interruptible {
  public:
    Interruptible();
    ~Interruptible();
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;
};

// The signal that came, 0 for none.
int interruption();
// As the shell counts: 128 and the signal.
int interruption_code();

}  // namespace epode::cli
