// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A 64-bit fingerprint of numbers and words in their order: every word goes through
//   h' = mix((h ^ w) + c),   mix(z) = (z ^ z >> 29) * m,  then  z ^ z >> 32      m odd
// which is one-to-one in h and in w, so that two texts which differ in one word alone never agree. Equal
// numbers have equal bits here: 0 and -0 do not.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>

#include "base/config.h"

namespace epode {

class ContentHash {
  public:
    void add(std::uint64_t word)
    {
        std::uint64_t z = (value_ ^ word) + 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 29) * 0xbf58476d1ce4e5b9u;
        value_ = z ^ z >> 32;
    }
    void add(Real x)
    {
        if constexpr (kSingle)
            add(std::uint64_t(std::bit_cast<std::uint32_t>(float(x))));
        else
            add(std::bit_cast<std::uint64_t>(double(x)));
    }
    void add(const Real* values, int count)
    {
        for (int i = 0; i < count; ++i) add(values[i]);
    }
    void add(std::initializer_list<Real> values)
    {
        for (const Real x : values) add(x);
    }
    void add(const char* text)
    {
        for (; *text; ++text) add(std::uint64_t(static_cast<unsigned char>(*text)));
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0;
};

}  // namespace epode
