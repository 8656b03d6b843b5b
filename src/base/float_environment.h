// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The floating-point environment that the library computes in, whatever the program has set: rounding to
// nearest, denormal numbers kept (neither flushed to zero nor read as zero), no exception that traps. Every
// thread has its own environment; without this, the modes of the host would change only the part of a step
// that runs on the calling thread.
//
//   FloatEnvironment        during a call: the library's modes; afterwards the program's, as they were.
//   CallerFloatEnvironment  around a function of the program that the library calls: the program's modes.
//
// Modes are switched only where they differ. Otherwise the first class costs a read of the control register
// and the second a read of a flag. A call that has switched modes restores the whole register, sticky flags
// included. A call in the usual modes leaves the flags raised that its arithmetic raises, as a function of
// the C library does; finding out would cost a second read, on some machines as much as a small collision.
// Functions of the program leave modes as they find them (C11, 7.6). If one sets modes and keeps them, they
// are the program's from then on, but the rest of a call in usual modes is computed in them.
//
// Compilers do not know that modes affect arithmetic. What is computed inside a FloatEnvironment therefore
// reads its operands from memory or stands in a function of its own; it does not use arguments in registers.
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

// What standard C can tell: rounding, and traps where the C library reports them.
inline bool has_library_modes()
{
#if defined(__GLIBC__) && defined(_GNU_SOURCE)
    if (fegetexcept() != 0) return false;
#endif
    return std::fegetround() == FE_TONEAREST;
}

#endif

// For the calling thread: saves the program's registers, sets the library's, and later restores them.
[[gnu::cold]] void enter_library_modes();
[[gnu::cold]] void leave_library_modes();

// Restores the program's registers around a function of the program. False: they do not differ.
[[gnu::cold]] bool enter_program_modes();
[[gnu::cold]] void leave_program_modes();

// True if a thread has ever entered with other modes.
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
