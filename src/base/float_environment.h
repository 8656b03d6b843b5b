// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The floating-point environment that the library computes in, whatever the program has set: rounding to
// nearest, denormal numbers kept (neither flushed to zero nor read as zero), no exception that traps. Threads
// have each their own environment, so a host's mode would else change the caller's share of a step alone.
//   FloatEnvironment        for the time of a call: ours; then the program's again, as it was.
//   CallerFloatEnvironment  around a function of the program that is called inside: the program's.
// Modes are switched only where they differ: else the first costs a read of the control register, the second
// one of a flag. A call with other modes gives the whole register back, sticky flags included. With the usual
// modes the flags that our arithmetic raises stay raised, as after a function of the C library: to find out
// costs a second read, on some machines as much as a small collision.
// Functions of the program leave modes as they find them, by C's convention (7.6 of C11): modes that one sets
// and keeps are the program's from then on, but the rest of a call with usual modes is computed in them.
//
// Compilers do not know that modes matter to arithmetic. What is computed below a FloatEnvironment therefore
// comes from memory, or in a function of its own, not from arguments in registers alone.
#pragma once

#include <atomic>
#if defined(__SSE2__)
#elif defined(__aarch64__)
#include <cstdint>
#else
#include <cfenv>
#endif

namespace epode {

#if defined(__SSE2__)

// MXCSR: six sticky flags, denormals are zero, masks of the six exceptions, rounding, flush to zero.
inline bool has_library_modes() { return (__builtin_ia32_stmxcsr() & ~0x3fu) == 0x1f80u; }

#elif defined(__aarch64__)

// FPCR: rounding, flush to zero, default NaN, traps; all of it zero. The sticky flags are FPSR's.
inline bool has_library_modes()
{
    std::uint64_t control;
    asm volatile("mrs %0, fpcr" : "=r"(control));
    return control == 0;
}

#else

// What C knows of it: rounding, and traps where the library can tell.
inline bool has_library_modes()
{
#if defined(__GLIBC__) && defined(_GNU_SOURCE)
    if (fegetexcept() != 0) return false;
#endif
    return std::fegetround() == FE_TONEAREST;
}

#endif

// Of the calling thread: the program's registers are kept, ours set, and the way back.
[[gnu::cold]] void enter_library_modes();
[[gnu::cold]] void leave_library_modes();

// The program's registers again, for a function of it. False: there are no others.
[[gnu::cold]] bool enter_program_modes();
[[gnu::cold]] void leave_program_modes();

// Has a thread ever come with other modes?
extern constinit std::atomic<bool> g_other_modes;

class FloatEnvironment {
  public:
    FloatEnvironment() : entered_(!has_library_modes())
    {
        if (entered_) [[unlikely]]
            enter_library_modes();
    }
    ~FloatEnvironment()
    {
        if (entered_) [[unlikely]]
            leave_library_modes();
    }
    FloatEnvironment(const FloatEnvironment&) = delete;
    FloatEnvironment& operator=(const FloatEnvironment&) = delete;

  private:
    const bool entered_;
};

class CallerFloatEnvironment {
  public:
    CallerFloatEnvironment()
        : entered_(g_other_modes.load(std::memory_order_relaxed) && enter_program_modes())
    {}
    ~CallerFloatEnvironment()
    {
        if (entered_) [[unlikely]]
            leave_program_modes();
    }
    CallerFloatEnvironment(const CallerFloatEnvironment&) = delete;
    CallerFloatEnvironment& operator=(const CallerFloatEnvironment&) = delete;

  private:
    const bool entered_;
};

}  // namespace epode
