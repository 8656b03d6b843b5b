// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sleeping until a number changes: std::atomic's wait and notify_all, but on Windows the system's own, because
// those of MinGW-w64's libstdc++ 12 lose wake-ups.
#pragma once

#include <atomic>

namespace epode {

void wait_while(std::atomic<unsigned>& number, unsigned is);  // may return early
void wake_waiting(std::atomic<unsigned>& number);             // after a change

}  // namespace epode
