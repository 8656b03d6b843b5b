// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Messages on stderr. What the program printed before comes first: stdout is flushed.
#include "messages.h"

#include <cstdio>
#include <cstdlib>

namespace epode::drawstuff {

void print_failure(const char* title, const char* format, std::va_list values)
{
    std::fflush(stdout);
    std::fprintf(stderr, "\n%s: ", title);
    std::vfprintf(stderr, format, values);
    std::fputc('\n', stderr);
    std::fflush(stderr);
}

void fail(const char* format, ...)
{
    std::va_list values;
    va_start(values, format);
    print_failure("Error", format, values);
    va_end(values);
    std::exit(1);
}

void abort_with(const char* format, ...)
{
    std::va_list values;
    va_start(values, format);
    print_failure("INTERNAL ERROR", format, values);
    va_end(values);
    std::abort();
}

void note(const char* format, ...)
{
    std::va_list values;
    va_start(values, format);
    std::fputs("drawstuff: ", stderr);
    std::vfprintf(stderr, format, values);
    std::fputc('\n', stderr);
    va_end(values);
}

}  // namespace epode::drawstuff
