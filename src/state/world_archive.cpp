// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/world_archive.h"

#include <new>

#include "base/memory.h"

namespace epode {
namespace {

WorldArchive& archive_of(StepObserver& observer) { return static_cast<WorldArchive&>(observer); }

void destroy(StepObserver& observer)
{
    WorldArchive& archive = archive_of(observer);
    archive.~WorldArchive();
    release(&archive, sizeof archive);
}

}  // namespace

History* history_of(const World& world)
{
    StepObserver* const archive = world.step_state ? world.step_state->archive : nullptr;
    return archive ? &archive_of(*archive).history : nullptr;
}

WorldArchive* archive_of(World& world)
{
    StepState* const kept = step_state(world);
    if (!kept) return nullptr;
    if (kept->archive) return &archive_of(*kept->archive);
    void* memory = allocate(sizeof(WorldArchive));
    if (!memory) return nullptr;
    auto* const archive = new (memory) WorldArchive(world);
    archive->destroy = destroy;
    archive->end = [](StepObserver& observer, World&, Real, bool made) {
        if (made) archive_of(observer).history.step_made();
    };
    kept->archive = archive;
    return archive;
}

bool any_history() { return History::worlds() > 0; }

bool keep_for_history(Body& body)
{
    History* const history = history_of(*body.world);
    return history && history->keep(body);
}

bool keep_for_history(Joint& joint, dJointGroupID group)
{
    History* const history = joint.world ? history_of(*joint.world) : nullptr;
    return history && history->keep(joint, group);
}

bool keep_for_history(Geom& geom)
{
    return geom.recorder && static_cast<History*>(geom.recorder)->keep(geom);
}

}  // namespace epode
