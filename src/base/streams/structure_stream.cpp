// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "base/streams/structure_stream.h"

#include <climits>
#include <limits>

#include "base/check.h"

namespace epode {

int StructureStream::count(int value, std::size_t size, const char* text)
{
    std::uint32_t number = std::uint32_t(value);
    numbers(&number, 1);
    if (saves()) return value;
    if (number > std::uint32_t(INT_MAX) || number * size > left()) {
        fail("%u %s do not fit into the %zu bytes that are left", number, text, left());
        return 0;
    }
    return int(number);
}

void StructureStream::reals(Real* values, int count, Range range, Real low)
{
    numbers(values, std::size_t(count));
    if (saves()) return;
    const Real limit = range == kInfinite ? kInf : std::numeric_limits<Real>::max();
    for (int i = 0; i < count; ++i)
        if (!within(values[i], limit) || values[i] < low) {
            fail("a number in it is not finite, or one that it cannot be");
            values[i] = 0;
        }
}

void StructureStream::sizes(Real* values, int count)
{
    reals(values, count, kFinite, 0);
    for (int i = 0; loads() && i < count; ++i)
        if (!demand(usable(values[i]), "a size in it is larger than the interface takes")) values[i] = 0;
}

bool StructureStream::grow(std::size_t size)
{
    if (failed()) return false;
    const std::size_t wanted = size + size / 2 + 4096;
    return demand(wanted <= std::size_t(INT_MAX) && to_->reserve(int(wanted)), kOutOfMemory);
}

}  // namespace epode
