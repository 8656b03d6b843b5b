// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Floating-point environments that a host may have set, as what the processor's control register then holds:
// the three other roundings, denormals flushed or read as zero, exceptions that trap.
#pragma once

#include <cstdint>
#include <string>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace epode::physics {

struct FloatRegisters {
    std::uint64_t control, flags;
    bool operator==(const FloatRegisters&) const = default;
};

struct FloatMode {
    const char* name;
    std::uint64_t control;
};

#if defined(__SSE2__)

inline constexpr FloatMode kFloatModes[] = {{"upward", 0x5f80},       {"downward", 0x3f80},
                                            {"towards_zero", 0x7f80}, {"flush_to_zero", 0x9f80},
                                            {"no_denormals", 0x9fc0}, {"denormals_are_zero", 0x1fc0},
                                            {"traps", 0x1900}};
// Even of what is not exact: for calls that leave the program nothing to compute.
inline constexpr FloatMode kEverythingTraps{"everything_traps", 0};
inline constexpr std::uint64_t kUsualControl = 0x1f80;
inline FloatRegisters float_registers()
{
    const unsigned all = _mm_getcsr();
    return {all & ~0x3fu, all & 0x3fu};
}
inline void set_float_registers(FloatRegisters r) { _mm_setcsr(unsigned(r.control | r.flags)); }

#elif defined(__aarch64__)

// (Traps are optional on ARM, and QEMU has none: the register keeps zeros there.)
inline constexpr FloatMode kFloatModes[] = {{"upward", 1u << 22},
                                            {"downward", 2u << 22},
                                            {"towards_zero", 3u << 22},
                                            {"flush_to_zero", 1u << 24},
                                            {"default_nan", 1u << 25}};
inline constexpr FloatMode kEverythingTraps{"everything_traps", 0x9f00};
inline constexpr std::uint64_t kUsualControl = 0;
inline FloatRegisters float_registers()
{
    FloatRegisters r;
    asm volatile("mrs %0, fpcr\n\tmrs %1, fpsr" : "=r"(r.control), "=r"(r.flags) : : "memory");
    return r;
}
inline void set_float_registers(FloatRegisters r)
{
    asm volatile("msr fpcr, %0\n\tmsr fpsr, %1" : : "r"(r.control), "r"(r.flags) : "memory");
}

#endif

#if defined(__SSE2__) || defined(__aarch64__)
#define EPODE_HAS_FLOAT_MODES 1

// What a host finds again after a call: all of it, or the modes, where the program computes inside.
enum class Keeps { kRegisters, kModes };

// The mode for the time of a scope, with one sticky flag raised; `kept` becomes false if it is not found
// again.
class HostMode {
  public:
    HostMode(const FloatMode& mode, bool& kept, Keeps keeps = Keeps::kRegisters)
        : before_(float_registers()), keeps_(keeps), kept_(kept)
    {
        set_float_registers({mode.control, 4});
        mine_ = float_registers();
    }
    ~HostMode()
    {
        const FloatRegisters now = float_registers();
        set_float_registers(before_);
        // With the usual modes, as they are where the machine has no traps, flags may be raised.
        const bool modes_only = keeps_ == Keeps::kModes || mine_.control == kUsualControl;
        kept_ = kept_ && (modes_only ? now.control == mine_.control : now == mine_);
    }
    HostMode(const HostMode&) = delete;
    HostMode& operator=(const HostMode&) = delete;

  private:
    const FloatRegisters before_;
    FloatRegisters mine_;
    const Keeps keeps_;
    bool& kept_;
};

#endif

}  // namespace epode::physics
