// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's handlers take no user data, hence the one counter of the process.
#include "scenes/messages.h"

#include <ode/ode.h>

#include <cstdarg>
#include <cstdio>

namespace epode::scenes {

namespace {

constexpr int kShown = 5;
int g_count = 0;

void note(const char* kind, int number, const char* text, va_list arguments)
{
    if (++g_count > kShown) return;
    std::fprintf(stderr, "ODE %s %d: ", kind, number);
    std::vfprintf(stderr, text, arguments);
    std::fputc('\n', stderr);
}

void on_message(int number, const char* text, va_list arguments) { note("message", number, text, arguments); }
void on_error(int number, const char* text, va_list arguments) { note("error", number, text, arguments); }
void on_debug(int number, const char* text, va_list arguments)
{
    note("failed check", number, text, arguments);
}

}  // namespace

MessageCounter::MessageCounter()
{
    g_count = 0;
    dSetMessageHandler(on_message);
    dSetErrorHandler(on_error);
    dSetDebugHandler(on_debug);
}

MessageCounter::~MessageCounter()
{
    dSetMessageHandler(nullptr);
    dSetErrorHandler(nullptr);
    dSetDebugHandler(nullptr);
}

int MessageCounter::count() const { return g_count; }

}  // namespace epode::scenes
