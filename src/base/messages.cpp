// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Handlers are process-wide, as in ODE. They are atomics so that a worker thread may report while the client
// installs one.
#include "base/messages.h"

#include <atomic>
#include <cstdio>

#include "base/float_environment.h"

namespace epode {
namespace {

struct Handler {
    dMessageFunction* function;
};
std::atomic<Handler> g_handlers[3];

void print(Channel channel, int number, const char* format, va_list arguments)
{
    static constexpr const char* kTitle[] = {"ODE Error", "ODE INTERNAL ERROR", "ODE Message"};
    std::fflush(stdout);
    std::fprintf(stderr, number ? "\n%s %d: " : "\n%s: ", kTitle[int(channel)], number);
    std::vfprintf(stderr, format, arguments);
    std::fputc('\n', stderr);
    std::fflush(stderr);
}

}  // namespace

dMessageFunction* handler(Channel channel) noexcept { return g_handlers[int(channel)].load().function; }

void set_handler(Channel channel, dMessageFunction* function) noexcept
{
    g_handlers[int(channel)].store({function});
}

void deliver(Channel channel, int number, const char* format, va_list arguments)
{
    const CallerFloatEnvironment program;
    if (dMessageFunction* installed = handler(channel)) {
        installed(number, format, arguments);
    } else {
        print(channel, number, format, arguments);
    }
}

void note(int number, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    deliver(Channel::kMessage, number, format, arguments);
    va_end(arguments);
}

}  // namespace epode
