// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A 64-bit checksum of bytes, as fast as memory can be read: eight lanes, each with every eighth word w of
// eight bytes,
//   s' = rotate(s ^ w, 29) * m        m odd
// which is one-to-one in s and in w. A change that stays within one word is therefore always noticed, any
// other with a probability of 1 - 2^-64. A CRC promises the same of 32 bits and takes a table, or
// instructions that not every machine has.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epode {

std::uint64_t checksum(const void* bytes, std::size_t count);

}  // namespace epode
