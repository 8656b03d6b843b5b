// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a reader may take. Memory: at most 16 times its input, and a constant for what is there once (pools of
// objects, an empty world). Time: a second of the processor, whatever else the machine does. What takes more
// traps, which libFuzzer reports as a crash.
#pragma once

#include <ode/ode.h>
#include <time.h>

#include <cstddef>
#include <cstdlib>

namespace epode::fuzz {

class Meter {
  public:
    static constexpr std::size_t kTimes = 16, kOnce = 1 << 20;

    static constexpr double kSeconds = 1;

    // While it lives, memory is limited by so many bytes of input.
    explicit Meter(std::size_t input) : began_(seconds()) { limit_ = live_ + long(kTimes * input + kOnce); }
    ~Meter()
    {
        limit_ = kNone;
        if (seconds() - began_ > kSeconds) __builtin_trap();
    }
    Meter(const Meter&) = delete;
    Meter& operator=(const Meter&) = delete;

    static void took(std::size_t bytes)
    {
        live_ += long(bytes);
        if (live_ > limit_) __builtin_trap();
    }
    static void gave(std::size_t bytes) { live_ -= long(bytes); }

  private:
    static double seconds()
    {
        timespec now;
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
    }

    const double began_;
    static constexpr long kNone = 1L << 62;
    static inline long live_ = 0, limit_ = kNone;
};

// All memory of the library passes the meter from now on.
inline void meter_library()
{
    dSetAllocHandler([](dsizeint size) -> void* { return Meter::took(size), std::malloc(size); });
    dSetReallocHandler([](void* block, dsizeint old, dsizeint size) -> void* {
        Meter::took(size), Meter::gave(old);
        return std::realloc(block, size);
    });
    dSetFreeHandler([](void* block, dsizeint size) { block ? Meter::gave(size) : void(), std::free(block); });
}

}  // namespace epode::fuzz
