// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "query/effort.h"

#include <atomic>

#include "base/messages.h"

namespace epode {

// Where nobody handles messages, once: a program may ask in each of its frames.
void report_cut_short(const char* function)
{
    static std::atomic<bool> said{false};
    if (!handler(Channel::kMessage) && said.exchange(true, std::memory_order_relaxed)) return;
    note(0,
         "%s: a geom covers more of a surface than is looked at, %lld cells of a height field; the answer is "
         "of "
         "those around its middle",
         function, static_cast<long long>(Effort::kCells));
}

}  // namespace epode
