// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A state as a difference from another one, word by word (four bytes): runs of
//   from, same, own   then `own` words        copy `same` words of the base from word `from`, then take these
// where each run begins in the base behind the end of the one before. Parts keep their order in a state and
// seldom move, so a run mostly goes on where the last one ended, less what has changed; where something has
// come or gone the place is found again by a table of the base's words, four at a time. A difference and its
// base together are never shorter than what they make up, so reading takes no more memory than was given.
#pragma once

#include <cstddef>
#include <span>

#include "base/array.h"

namespace epode {

// Writes the difference between two sealed states. False: out of memory.
[[nodiscard]] bool write_delta(std::span<const std::byte> base, std::span<const std::byte> state,
                               Array<std::uint32_t>& out);

// Null: `out` is the state; else what is wrong. `base` and `delta` are any bytes.
const char* read_delta(std::span<const std::byte> base, std::span<const std::byte> delta,
                       Array<std::uint32_t>& out, char* text, std::size_t text_size);

}  // namespace epode
