// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A number that changes whenever bodies, lasting joints or geoms are created, destroyed, attached or given
// another mass, shape or offset, in any world of the process. Who has looked at a structure need not look
// again while the number is the same. One number for all worlds: geoms belong to no world, and a look too
// many does no harm.
#pragma once

#include <atomic>
#include <cstdint>

namespace epode {

inline std::atomic<std::uint64_t> g_structure_edition{1};

inline std::uint64_t structure_edition() { return g_structure_edition.load(std::memory_order_relaxed); }
inline void note_structure_changed() { g_structure_edition.fetch_add(1, std::memory_order_relaxed); }

}  // namespace epode
