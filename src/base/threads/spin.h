// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#pragma once

#include <sched.h>

namespace epode {

// Tells the processor that this is a loop that waits.
inline void spin_once()
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

// Another thread may have this one's core.
inline void yield_core() { sched_yield(); }

}  // namespace epode
