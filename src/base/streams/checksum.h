// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// 64 bits that tell bytes from others: a changed text keeps its checksum with a probability of about 2^-64. A
// CRC promises the same of 32 bits and takes a table, or instructions that not every machine has. Four lanes
// take two words w each in turn, by a product of 128 bits of which both halves are added without carry:
//   s' = fold((w0 ^ s) (w1 ^ k)),   fold(p) = p ^ p >> 64
// Format 3 of states and format 1 of files of worlds have eight lanes of one word: s' = rotate(s ^ w, 29) m.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epode {

std::uint64_t checksum(const void* bytes, std::size_t count);
// The same, and copies them.
std::uint64_t copy_and_sum(void* to, const void* bytes, std::size_t count);

std::uint64_t checksum_3(const void* bytes, std::size_t count);

}  // namespace epode
