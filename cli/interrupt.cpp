// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See interrupt.h. A signal that the program was started to ignore (nohup, a job in the background) stays
// ignored.
#include "cli/interrupt.h"

#include <signal.h>

#include <iterator>

namespace epode::cli {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM};
volatile sig_atomic_t came = 0;
struct sigaction before[std::size(kSignals)];

void remember(int signal) { came = signal; }

}  // namespace

Interruptible::Interruptible()
{
    for (size_t i = 0; i < std::size(kSignals); ++i) {
        struct sigaction action = {};
        action.sa_handler = remember;
        action.sa_flags = int(SA_RESETHAND) | SA_RESTART;
        sigaction(kSignals[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
    }
}

Interruptible::~Interruptible()
{
    for (size_t i = 0; i < std::size(kSignals); ++i) sigaction(kSignals[i], &before[i], nullptr);
}

int interruption() { return came; }
int interruption_code() { return 128 + came; }

}  // namespace epode::cli
