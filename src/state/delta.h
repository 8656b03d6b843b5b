// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A state as a difference from another one, word by word (four bytes): runs of
//   from, same, own   then `own` words        copy `same` words of the base from word `from`, then take these
// where each run begins in the base after the end of the previous one. Parts of a state keep their order and
// seldom move, so a run usually continues where the last one ended, after the changed words. Where words were
// inserted or removed, a hash table of all windows of eight words of the base finds the place again. A
// difference and its base together are never shorter than the state, so reading allocates at most their size.
#pragma once

#include <cstddef>
#include <span>

#include "base/array.h"

namespace epode {

// Writes the difference between two sealed states. False: out of memory.
[[nodiscard]] bool write_delta(std::span<const std::byte> base, std::span<const std::byte> state,
                               Array<std::uint32_t>& out);

// Null: `out` is the state; else what is wrong. `base` and `delta` may be any bytes.
const char* read_delta(std::span<const std::byte> base, std::span<const std::byte> delta,
                       Array<std::uint32_t>& out, char* text, std::size_t text_size);

}  // namespace epode
