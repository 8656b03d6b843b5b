// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The time left is guessed from the mean pace so far: steps of one scene cost much the same.
#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/console.h"

namespace epode::cli {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

}  // namespace

Progress::Progress(std::string name, int steps, bool wanted)
    : name_(std::move(name)),
      steps_(steps),
      wanted_(wanted),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      next_(start_ + (terminal_ ? 1000ms : 2000ms))
{}

Progress::~Progress()
{
    // Leaves the terminal as it was: the report belongs there.
    if (drawn_ && terminal_) put_error("\r\033[K");
}

void Progress::show(int done, size_t contacts)
{
    if (!wanted_ || done == steps_) return;
    const auto now = Clock::now();
    if (now < next_) return;
    const double spent = std::chrono::duration<double>(now - start_).count();
    const std::string line =
        fmt::format("{}: step {} of {} ({} %), {} contacts, about {:.0f} s left", name_, done, steps_,
                    100LL * done / steps_, contacts, spent * (steps_ - done) / done);
    put_error(terminal_ ? "\r\033[K" + line : line + "\n");
    drawn_ = true;
    next_ = now + (terminal_ ? 200ms : 10000ms);
}

}  // namespace epode::cli
