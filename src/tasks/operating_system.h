// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What tasks ask of the operating system where POSIX, Windows and WebAssembly differ. The rest, threads and
// clocks, MinGW-w64 has as POSIX does (and WebAssembly as base/threads/one_thread.h does).
#pragma once

#include <limits.h>

#include <cstddef>
#include <cstdint>

#include "base/threads/system_threads.h"
#if !defined(__wasm__)
#include <thread>
#endif
#if !defined(_WIN32) && !defined(__wasm__)
#include <signal.h>
#include <sys/resource.h>
#endif

namespace epode {

// 0: unknown.
inline unsigned system_processors()
{
#if defined(__wasm__)
    return 1;
#else
    return std::thread::hardware_concurrency();
#endif
}

// How often this thread lost its core although it could have continued; 0 where the system does not tell.
inline long times_unseated()
{
#ifdef RUSAGE_THREAD
    rusage usage;
    if (getrusage(RUSAGE_THREAD, &usage) == 0) return usage.ru_nivcsw;
#endif
    return 0;
}

#if defined(_WIN32) || defined(__wasm__)

// Of a thread, bytes. Windows takes 32 bits of it and says nothing.
inline constexpr std::size_t kLeastStack = 16 * 1024, kMostStack = INT32_MAX;

// There are no forks.
inline void at_fork(void (*)(), void (*)(), void (*)()) {}

// Threads are not interrupted by signals.
class BlockedSignals {
  public:
    BlockedSignals() {}
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;
};

#else

inline const std::size_t kLeastStack = std::size_t(PTHREAD_STACK_MIN);
inline constexpr std::size_t kMostStack = SIZE_MAX;  // the system refuses what it has not

inline void at_fork(void (*before)(), void (*in_parent)(), void (*in_child)())
{
    pthread_atfork(before, in_parent, in_child);
}

// A new thread takes no signals: it inherits the mask that is set while it is created.
class BlockedSignals {
  public:
    BlockedSignals()
    {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  private:
    sigset_t before_;
};

#endif

}  // namespace epode
