// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A thread is either inside a library call with switched modes (t_inside) or in the program. A function of
// the program that the library calls counts as the program: calls that it makes itself enter the library
// again.
#include "base/float_environment.h"

namespace epode {

constinit std::atomic<bool> g_other_modes{false};

namespace {

#if defined(__SSE2__)

using Registers = unsigned;
Registers read() { return __builtin_ia32_stmxcsr(); }
void write(Registers r) { __builtin_ia32_ldmxcsr(r); }
void write_ours() { write(0x1f80); }

#elif defined(__aarch64__)

struct Registers {
    std::uint64_t control, status;
};
Registers read()
{
    Registers r;
    asm volatile("mrs %0, fpcr\n\tmrs %1, fpsr" : "=r"(r.control), "=r"(r.status) : : "memory");
    return r;
}
void write(Registers r)
{
    asm volatile("msr fpcr, %0\n\tmsr fpsr, %1" : : "r"(r.control), "r"(r.status) : "memory");
}
void write_ours() { write({0, 0}); }

#else

using Registers = std::fenv_t;
Registers read()
{
    Registers r;
    std::fegetenv(&r);
    return r;
}
void write(const Registers& r) { std::fesetenv(&r); }
void write_ours()
{
    Registers before;
    std::feholdexcept(&before);
    std::fesetround(FE_TONEAREST);
}

#endif

constinit thread_local bool t_inside = false;
constinit thread_local Registers t_program = {};

}  // namespace

void enter_library_modes()
{
    g_other_modes.store(true, std::memory_order_relaxed);
    t_program = read();
    t_inside = true;
    write_ours();
}

void leave_library_modes()
{
    write(t_program);
    t_inside = false;
}

bool enter_program_modes()
{
    if (!t_inside) return false;
    t_inside = false;
    write(t_program);
    return true;
}

// Flags raised and modes set by the program's function belong to the program.
void leave_program_modes()
{
    t_program = read();
    t_inside = true;
    write_ours();
}

}  // namespace epode
