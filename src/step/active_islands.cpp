// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/active_islands.h"

#include "dynamics/active.h"
#include "step/validate.h"

namespace epode {

bool ActiveIslands::find(StepUndo& undo, Arena& arena)
{
    updates_contacts_ = manages_contacts() && !is_settled();
    if (!find_unsupported()) return false;
    if (updates_contacts_ && !leaves_at_rest(world_.bodies.active_count())) activate_all(world_);
    return undo.save_idleness(arena) && undo.wake(state_.unsupported.span(), arena) && find_contacts() &&
           find_islands(arena) && undo.save_islands(islands_, arena);
}

// All bodies sleep, and their contacts are up to date.
bool ActiveIslands::is_settled() const
{
    return world_.bodies.active_count() == 0 &&
           state_.world_contacts.is_settled(*state_.world_contacts.live_space());
}

bool ActiveIslands::leaves_at_rest(int active) const
{
    return state_.world_contacts.leaves_at_rest(*state_.world_contacts.live_space(),
                                                {active, world_.bodies.count()});
}

bool ActiveIslands::find_unsupported()
{
    state_.unsupported.clear();
    ContactWorld& contacts = state_.world_contacts;
    return !updates_contacts_ ||
           contacts.find_unsupported(world_, *contacts.live_space(), state_.unsupported);
}

bool ActiveIslands::find_contacts()
{
    ContactWorld& contacts = state_.world_contacts;
    return !updates_contacts_ || contacts.update(world_, *contacts.live_space(), h_, tasks_);
}

// Activates inactive bodies that an active one touches or holds by a joint; then finds the islands again.
bool ActiveIslands::find_islands(Arena& arena)
{
    std::span<ManifoldEdge> manifolds;
    Islands found;
    do {
        if (updates_contacts_)
            state_.world_contacts.show_manifolds(tasks_);  // those of bodies that were reached
        if (updates_contacts_ && !state_.world_contacts.touching(tasks_, arena, manifolds)) return false;
        if (!epode::find_islands(world_, h_, manifolds, arena, found)) return false;
        if (world_.reached.empty()) break;
    } while (activate_reached());
    EPODE_ASSERT(!world_.reached.empty() || !fault_of(world_, found, arena));
    islands_ = found.all, asleep_ = found.asleep;
    return world_.reached.empty();
}

bool ActiveIslands::activate_reached()
{
    if (!updates_contacts_) return epode::activate_reached(world_, [](Body&) { return true; });
    ContactWorld& contacts = state_.world_contacts;
    const auto bring = [&](Body& body) { return contacts.bring_pairs(body, world_.reached); };
    return epode::activate_reached(world_, bring) && contacts.list_brought(world_);
}

void ActiveIslands::accept_contacts() const
{
    if (updates_contacts_) return state_.world_contacts.accept(h_, tasks_);
    if (manages_contacts()) state_.world_contacts.accept_settled(h_);
}

void ActiveIslands::list_events() const
{
    state_.events.begin_step(world_, updates_contacts_ ? &state_.world_contacts : nullptr);
}

void ActiveIslands::deactivate_sleeping() const
{
    if (manages_contacts() && !leaves_at_rest(world_.bodies.active_count() - int(asleep_.size()))) return;
    for (Body* body : asleep_) deactivate(*body);
    if (updates_contacts_) state_.world_contacts.lay_to_rest();
}

}  // namespace epode
