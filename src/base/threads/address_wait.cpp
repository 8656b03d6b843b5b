// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "base/threads/address_wait.h"

#if defined(_WIN32)
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#endif

namespace epode {

#if defined(_WIN32)

static_assert(sizeof(std::atomic<unsigned>) == sizeof(unsigned) &&
              std::atomic<unsigned>::is_always_lock_free);

void wait_while(std::atomic<unsigned>& number, unsigned is)
{
    ::WaitOnAddress(&number, &is, sizeof is, INFINITE);
}

void wake_waiting(std::atomic<unsigned>& number) { ::WakeByAddressAll(&number); }

#else

void wait_while(std::atomic<unsigned>& number, unsigned is) { number.wait(is, std::memory_order_acquire); }
void wake_waiting(std::atomic<unsigned>& number) { number.notify_all(); }

#endif

}  // namespace epode
