// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "base/streams/state_bytes.h"

#include <algorithm>
#include <climits>
#include <cstring>

#include "base/memory.h"

namespace epode {

constexpr std::size_t kLeast = 1024;

bool StateBytes::reserve(std::size_t wanted)
{
    if (wanted <= capacity) return true;
    if (wanted > std::size_t(INT_MAX)) return false;
    const std::size_t larger = std::max(wanted + wanted / 4, kLeast);
    auto* const grown = static_cast<std::byte*>(allocate(larger));
    if (!grown) return false;
    if (size > 0) std::memcpy(grown, data, size);
    const std::size_t kept = size;
    release();
    data = grown, size = kept, capacity = larger;
    return true;
}

void StateBytes::release()
{
    if (data) epode::release(data, capacity);
    *this = {};
}

}  // namespace epode
