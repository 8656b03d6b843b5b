// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "base/streams/state_stream.h"

namespace epode {

bool StateStream::grow(std::size_t count)
{
    out_->size = written();
    if (!demand(out_->reserve(out_->size + count), kOutOfMemory)) return false;
    at_ = out_->data + out_->size, end_ = out_->data + out_->capacity;
    return true;
}

void StateStream::number(const Number& n)
{
    const auto judge = [&](const std::byte* from) {
        const Real x = get_little<Real>(from);
        if (n.computed) return within(x, n.infinite ? kInf : std::numeric_limits<Real>::max());
        return (n.infinite ? usable_or_infinite(x) : usable(x)) && x >= n.least;
    };
    numbers(n.value, 1, judge);
}

std::uint32_t StateStream::unusual(std::initializer_list<Number> numbers, std::uint32_t bits)
{
    std::uint32_t mask = bits << 16, bit = 1;
    if (saves())
        for (const Number& n : numbers) {
            if (std::memcmp(n.value, &n.usual, sizeof(Real)) != 0) mask |= bit;
            bit <<= 1;
        }
    mask = word(mask);
    bit = 1;
    for (const Number& n : numbers) {
        if (mask & bit)
            number(n);
        else if (stores() && !failed())
            *n.value = n.usual;
        bit <<= 1;
    }
    return mask >> 16;
}

}  // namespace epode
