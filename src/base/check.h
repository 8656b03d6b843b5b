// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Strengths of checking.
//
//   EPODE_ASSERT(c)             an invariant of the library; Debug builds only; stops the program there.
//   EPODE_ASSERT_NO_FAULT(text) the same of a text that names what is broken, or is null.
//   EPODE_USER(c, result)       an argument of a public call, in Release too. If c is false the call is
//                               refused: it returns `result` (nothing for void functions) and sends one
//                               message to the debug handler in ODE's words ("Bad argument(s) in dFoo()").
//                               Without a handler the message is printed once per call site.
//   EPODE_USER_SAY(c, text, r)  the same with another text.
//   usable(x)                   is a number from a client finite and not absurdly large?
//
// Refusing instead of calling abort() as ODE does is the first promise of the project: no argument may bring
// the host down.
#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "base/config.h"

namespace epode {

// Reports a refused public call: `text in function()`. `reported` remembers that a call site has printed.
[[gnu::cold]] void refuse(const char* text, const char* function, std::atomic<bool>& reported);

// Refuses a call in the name of the C function `caller`: EPODE_USER_SAY for helpers that many functions
// share.
[[gnu::cold]] void refuse_for(const char* caller, const char* text);

// The message of a call that finds no memory.
inline constexpr const char* kOutOfMemory = "out of memory";

#if defined(NDEBUG)
inline constexpr bool kAsserts = false;
#define EPODE_ASSERT(condition) ((void)sizeof(!(condition)))
#define EPODE_ASSERT_NO_FAULT(fault) ((void)sizeof(fault))
#else
inline constexpr bool kAsserts = true;
[[noreturn]] void assertion_failed(const char* expression, const char* file, int line);
#define EPODE_ASSERT(condition) \
    ((condition) ? (void)0 : ::epode::assertion_failed(#condition, __FILE__, __LINE__))
#define EPODE_ASSERT_NO_FAULT(fault)                                                                       \
    do {                                                                                                   \
        if (const char* epode_fault = (fault)) ::epode::assertion_failed(epode_fault, __FILE__, __LINE__); \
    } while (false)
#endif

#define EPODE_USER_SAY(condition, text, ...)                 \
    do {                                                     \
        if (!(condition) && kChecked) [[unlikely]] {         \
            static std::atomic<bool> epode_reported{false};  \
            ::epode::refuse(text, __func__, epode_reported); \
            return __VA_ARGS__;                              \
        }                                                    \
    } while (false)

#define EPODE_USER(condition, ...) EPODE_USER_SAY(condition, "Bad argument(s)" __VA_OPT__(, ) __VA_ARGS__)

// Largest magnitude accepted from a client; beyond it squares and volumes overflow.
inline constexpr Real kMaxMagnitude = kSingle ? Real(1e18) : Real(1e100);

// |x| <= limit, by the bits: comparing what is no number would trap in a host that has unmasked such
// exceptions.
constexpr bool within(Real x, Real limit)
{
    using Bits = std::conditional_t<kSingle, std::uint32_t, std::uint64_t>;
    constexpr Bits kMagnitude = ~Bits(0) >> 1;
    return (std::bit_cast<Bits>(x) & kMagnitude) <= std::bit_cast<Bits>(limit);
}

constexpr bool usable(Real x) { return within(x, kMaxMagnitude); }
constexpr bool usable_or_infinite(Real x)
{
    return usable(x) || (within(x, kInf) && !within(x, std::numeric_limits<Real>::max()));
}

inline bool usable(const Real* values, int count)
{
    for (int i = 0; i < count; ++i)
        if (!usable(values[i])) return false;
    return true;
}

// Of a dMatrix3, whose rows are four numbers long.
inline bool usable_matrix(const Real* R) { return R && usable(R, 3) && usable(R + 4, 3) && usable(R + 8, 3); }

}  // namespace epode
