// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "base/streams/first_fault.h"

#include <cstdarg>
#include <cstdio>

namespace epode {

void FirstFault::fail(const char* format, ...)
{
    if (failed()) return;
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text_, sizeof text_, format, arguments);
    va_end(arguments);
}

}  // namespace epode
