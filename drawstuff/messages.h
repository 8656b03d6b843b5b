// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How drawstuff ends a program that misuses it. That a library may end its host is drawstuff's contract, and
// only drawstuff's; all else in this project reports and goes on.
#pragma once

#include <cstdarg>

namespace epode::drawstuff {

// A blank line, title, message, newline on stderr.
void print_failure(const char* title, const char* format, std::va_list values);

[[noreturn]] void fail(const char* format, ...);  // exit code 1
[[noreturn]] void abort_with(const char* format, ...);

// "drawstuff: " before it and a newline after it, on stderr; the program goes on.
void note(const char* format, ...);

}  // namespace epode::drawstuff
