// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/undo.h"

#include <cstring>

namespace epode {
namespace {

// f(member of the body, member of the copy) for each array that both have.
template <typename B, typename S, typename Visit>
void for_members(B& body, S& saved, Visit&& f)
{
    f(body.pos, saved.pos), f(body.q, saved.q), f(body.R, saved.R);
    f(body.lvel, saved.lvel), f(body.avel, saved.avel);
    f(body.facc, saved.facc), f(body.tacc, saved.tacc);
}

}  // namespace

bool StepUndo::save(std::span<const Island> islands, Arena& arena)
{
    std::size_t count = 0;
    for (const Island& island : islands) count += island.bodies.size();
    saved_ = arena.take<Saved>(int(count));
    if (arena.failed()) return false;
    std::size_t at = 0;
    for (const Island& island : islands)
        for (const Body* body : island.bodies) {
            Saved& saved = saved_[at++];
            for_members(*body, saved, [](auto& from, auto& to) { std::memcpy(to, from, sizeof to); });
            saved.spin_excess = body->spin_excess;
        }
    return true;
}

void StepUndo::restore(std::span<const Island> islands) const
{
    std::size_t at = 0;
    for (const Island& island : islands)
        for (Body* body : island.bodies) {
            const Saved& saved = saved_[at++];
            for_members(*body, saved, [](auto& to, auto& from) { std::memcpy(to, from, sizeof to); });
            body->spin_excess = saved.spin_excess;
        }
}

}  // namespace epode
