// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The one place that reports refused calls, and the one place (Debug only) that stops the program.
#include "base/check.h"

#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include "base/messages.h"
#include "base/refusals.h"

namespace epode {
namespace {

[[gnu::format(printf, 2, 3)]] void report(int number, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    deliver(Channel::kDebug, number, format, arguments);
    va_end(arguments);
}

}  // namespace

void refuse(const char* text, const char* function, std::atomic<bool>& reported)
{
    if (text != kOutOfMemory) remember_refusal(function);
    // With a handler, every refusal is delivered. Without one, stderr gets one message per call site.
    if (!handler(Channel::kDebug) && reported.exchange(true)) return;
    report(d_ERR_UASSERT, "%s in %s()", text, function);
}

// The functions that have been refused already: without a handler, a message is printed once per C function,
// as EPODE_USER prints once per call site.
void refuse_for(const char* caller, const char* text)
{
    static std::atomic<const char*> refused[256] = {};
    std::atomic<bool> reported{true};  // silent once the table is full, which the number of functions forbids
    for (std::atomic<const char*>& slot : refused) {
        const char* present = nullptr;
        const bool first = slot.compare_exchange_strong(present, caller);
        if (!first && present != caller) continue;
        reported = !first;
        break;
    }
    refuse(text, caller, reported);
}

#if !defined(NDEBUG)
void assertion_failed(const char* expression, const char* file, int line)
{
    std::fprintf(stderr, "\nepode: assertion \"%s\" failed [%s:%d]\n", expression, file, line);
    std::abort();
}
#endif

}  // namespace epode
