// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is wrong with bytes that are read, in words. Only the first fault is kept: those after it follow from it.
#pragma once

#include "base/config.h"

namespace epode {

class FirstFault {
  public:
    bool failed() const { return text_[0] != 0; }
    const char* text() const { return text_; }
    [[gnu::format(EPODE_PRINTF, 2, 3)]] void fail(const char* format, ...);
    // Fails with the text unless the condition holds, which it returns.
    bool demand(bool condition, const char* text)
    {
        if (!condition) [[unlikely]]
            fail("%s", text);
        return condition;
    }

  private:
    char text_[160] = {};
};

}  // namespace epode
