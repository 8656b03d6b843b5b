// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Standard output and standard error, of which either may be a full disk, a closed pipe or nothing at all.
// Nothing here throws (fmt::print does): a failed write is remembered and reported once, by finish().
#pragma once

#include <fmt/format.h>

#include <string>

namespace epode::cli {

// Before anything else: a standard stream that the caller has closed must not become the first file that is
// opened, and the reader of a pipe may go away.
void open_console(bool ignore_broken_pipes);

void put(const std::string& text);
void put_error(const std::string& text);

template <class... Types>
void say(fmt::format_string<Types...> format, Types&&... values)
{
    put(fmt::format(format, std::forward<Types>(values)...));
}

// A line on standard error that begins with the program's name.
template <class... Types>
void warn(fmt::format_string<Types...> format, Types&&... values)
{
    put_error("epode: " + fmt::format(format, std::forward<Types>(values)...) + "\n");
}

// False once something could not be written to standard output: the rest need not be made.
bool can_say();
// The exit code, given that of the command: a problem where standard output did not take everything. Ends the
// process by SIGPIPE, silently, if that is because its reader is gone.
int finish_console(int code);

}  // namespace epode::cli
