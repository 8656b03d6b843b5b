// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the whole library is built on: the scalar of the build, its limits, and the few facts about
// the machine that code may rely on. Contradictory settings stop the build here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "ode/common.h"

#if defined(__FAST_MATH__)
#error "Epode promises the same bits everywhere: it must not be compiled with -ffast-math"
#endif

// Formats of messages are the C standard's, also where the system's own differ.
#if defined(__MINGW32__) && !defined(__clang__)
#define EPODE_PRINTF gnu_printf
#else
#define EPODE_PRINTF printf
#endif

namespace epode {

using Real = dReal;  // double, or float when the library is built with dIDESINGLE

inline constexpr Real kInf = std::numeric_limits<Real>::infinity();
inline constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();
inline constexpr Real kPi = Real(3.14159265358979323846);
inline constexpr std::size_t kCacheLine = 64;
inline constexpr bool kSingle = sizeof(Real) == 4;

// Off only in the library that bench/checks builds to measure the cost of checking arguments.
#if defined(EPODE_UNCHECKED)
inline constexpr bool kChecked = false;
#else
inline constexpr bool kChecked = true;
#endif

}  // namespace epode
