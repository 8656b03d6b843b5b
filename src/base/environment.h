// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Variables of the process environment, which choose what a program that is already built cannot.
#pragma once

#include <cstdlib>

namespace epode {

// A program with other rights than its caller's (set-user-ID) ignores the caller's environment.
inline const char* environment_value(const char* name)
{
#if defined(__linux__)
    return secure_getenv(name);
#else
    return std::getenv(name);
#endif
}

}  // namespace epode
