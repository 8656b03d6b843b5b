// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The three message channels as clients see them. dError and dDebug end the program, as documented, because
// it is the client who calls them; the library itself never does (base/check.h). A handler that does not
// return (longjmp, exception) is the client's way to survive its own call.
#include "ode/error.h"

#include <cstdlib>

#include "base/check.h"
#include "base/messages.h"

using namespace epode;

namespace {

const char* text(const char* format) { return format ? format : "(no text)"; }

}  // namespace

extern "C" void dSetErrorHandler(dMessageFunction* fn) { set_handler(Channel::kError, fn); }
extern "C" void dSetDebugHandler(dMessageFunction* fn) { set_handler(Channel::kDebug, fn); }
extern "C" void dSetMessageHandler(dMessageFunction* fn) { set_handler(Channel::kMessage, fn); }

extern "C" dMessageFunction* dGetErrorHandler(void) { return handler(Channel::kError); }
extern "C" dMessageFunction* dGetDebugHandler(void) { return handler(Channel::kDebug); }
extern "C" dMessageFunction* dGetMessageHandler(void) { return handler(Channel::kMessage); }

extern "C" void dError(int num, const char* msg, ...)
{
    va_list arguments;
    va_start(arguments, msg);
    deliver(Channel::kError, num, text(msg), arguments);
    va_end(arguments);
    std::exit(1);
}

extern "C" void dDebug(int num, const char* msg, ...)
{
    va_list arguments;
    va_start(arguments, msg);
    deliver(Channel::kDebug, num, text(msg), arguments);
    va_end(arguments);
    std::abort();
}

extern "C" void dMessage(int num, const char* msg, ...)
{
    EPODE_USER(msg);
    va_list arguments;
    va_start(arguments, msg);
    deliver(Channel::kMessage, num, msg, arguments);
    va_end(arguments);
}
