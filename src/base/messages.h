// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The three channels of ODE: error, debug and message, each with a replaceable handler. The library itself
// never stops its host: it reports and continues. Only a client's own call of dError or dDebug ends the
// program, as the guide documents (api/system/runtime.cpp).
#pragma once

#include <cstdarg>

#include "base/config.h"
#include "ode/error.h"

namespace epode {

enum class Channel { kError, kDebug, kMessage };

// The handler that the client installed, or null.
dMessageFunction* handler(Channel channel) noexcept;
void set_handler(Channel channel, dMessageFunction* function) noexcept;

// Calls the installed handler; without one prints in ODE's form to stderr.
void deliver(Channel channel, int number, const char* format, va_list arguments);

// A note to the client through dMessage's channel.
[[gnu::format(EPODE_PRINTF, 2, 3)]] void note(int number, const char* format, ...);

}  // namespace epode
